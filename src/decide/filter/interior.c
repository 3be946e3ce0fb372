/* Blocks of bricks are halved until no simplex meets them; the state of such a block is that of a
 * brick beside it, or of its middle. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <math.h>
#include <stdlib.h>
#include "decide/filter/search.h"

/* A grid has about BRICKS_A_SIMPLEX bricks for each simplex, at least LEAST_BRICKS and at most
 * MOST_BRICKS. It may take TESTS_EACH tests of a simplex against a box for each simplex, and as
 * many for each brick. */
enum { BRICKS_A_SIMPLEX = 8, LEAST_BRICKS = 1 << 14, MOST_BRICKS = 1 << 19, TESTS_EACH = 8 };

typedef struct block {
    size_t first[3], end[3];
} block;

typedef struct layer {
    interior *out;
    const graze_solid *solid;
    locate_function *locate;
    void *data;
    size_t tests;
} layer;

/* The lower end of brick i along an axis; bricks share their ends. */
static double brick_end(const interior *m, int axis, size_t i) {
    return m->low[axis] + (double)i * m->step[axis];
}

static box block_box(const interior *m, const block *b) {
    box out = {{0, 0, 0}, {0, 0, 0}};
    for (int k = 0; k < m->dimension; k++) {
        out.low[k] = brick_end(m, k, b->first[k]);
        out.high[k] = brick_end(m, k, b->end[k]);
    }
    return out;
}

static unsigned char *state_at(const interior *m, const size_t at[3]) {
    return m->state + (at[2] * m->count[1] + at[1]) * m->count[0] + at[0];
}

/* The state, if it is certain, of a brick that has a side in common with a brick of an empty block.
 */
static graze_state state_beside(const interior *m, const block *b) {
    for (int k = 0; k < m->dimension; k++)
        for (int up = 0; up < 2; up++) {
            size_t at[3] = {b->first[0], b->first[1], b->first[2]};
            if (up ? b->end[k] == m->count[k] : at[k] == 0)
                continue;
            at[k] = up ? b->end[k] : at[k] - 1;
            if (*state_at(m, at) != GRAZE_STATE_ABSENT)
                return (graze_state)*state_at(m, at);
        }
    return GRAZE_STATE_ABSENT;
}

static void fill_block(const interior *m, const block *b, graze_state state) {
    size_t at[3];
    for (at[2] = b->first[2]; at[2] < b->end[2]; at[2]++)
        for (at[1] = b->first[1]; at[1] < b->end[1]; at[1]++)
            for (at[0] = b->first[0]; at[0] < b->end[0]; at[0]++)
                *state_at(m, at) = (unsigned char)state;
}

static void take_empty(const layer *l, const block *b, const box *space) {
    graze_state state = state_beside(l->out, b);
    double middle[3];
    for (int k = 0; k < 3; k++)
        middle[k] = 0.5 * (space->low[k] + space->high[k]);
    if (state == GRAZE_STATE_ABSENT)
        state = l->locate(l->data, middle);
    fill_block(l->out, b, state);
}

/* Fill a block that no simplex meets with its state; halve others along the longest side. */
static void lay_block(layer *l, const block *b) {
    int axis = 0;
    for (int k = 1; k < 3; k++)
        if (b->end[k] - b->first[k] > b->end[axis] - b->first[axis])
            axis = k;
    box space = block_box(l->out, b);
    if (box_is_empty(l->solid, &space, &l->tests)) {
        take_empty(l, b, &space);
        return;
    }
    size_t length = b->end[axis] - b->first[axis];
    if (length < 2 || l->tests == 0)
        return;
    for (int half = 0; half < 2; half++) {
        block part = *b;
        if (half)
            part.first[axis] += length / 2;
        else
            part.end[axis] = part.first[axis] + length / 2;
        lay_block(l, &part);
    }
}

/* Divide a box into about `wanted` bricks with sides about equal; 0 if that takes more than 1024
 * along an axis. */
static int choose_bricks(interior *m, const box *all, size_t wanted) {
    double volume = 1;
    for (int k = 0; k < m->dimension; k++)
        volume *= all->high[k] - all->low[k];
    double side = pow(volume / (double)wanted, 1.0 / m->dimension);
    for (int k = 0; k < 3; k++) {
        double length = all->high[k] - all->low[k];
        double n = k < m->dimension ? ceil(length / side) : 1;
        if (!(n >= 1 && n <= 1024))
            return 0;
        m->count[k] = (size_t)n;
        m->low[k] = all->low[k];
        m->step[k] = length / n;
    }
    return 1;
}

int interior_make(interior *out, const graze_solid *solid, locate_function *locate, void *data) {
    *out = (interior){.dimension = solid->input.dimension};
    size_t simplices = (solid->boxes.node_count + 1) / 2, wanted = BRICKS_A_SIMPLEX * simplices;
    wanted = wanted < LEAST_BRICKS ? LEAST_BRICKS : wanted > MOST_BRICKS ? MOST_BRICKS : wanted;
    if (!solid->corners.at || !choose_bricks(out, &solid->boxes.node[0].box, wanted))
        return 1;
    out->state = calloc(out->count[0] * out->count[1] * out->count[2], 1);
    if (!out->state)
        return 0;
    layer l = {out, solid, locate, data, TESTS_EACH * (simplices + wanted)};
    lay_block(&l, &(block){{0, 0, 0}, {out->count[0], out->count[1], out->count[2]}});
    return 1;
}

void interior_clear(interior *m) {
    free(m->state);
    m->state = NULL;
}

/* Find the bricks `first` ... `end - 1` along an axis that cover [low, high]; 0 if none do. */
static int find_bricks(size_t *first, size_t *end, const interior *m, int axis, double low,
                       double high) {
    double from = (low - m->low[axis]) / m->step[axis], to = (high - m->low[axis]) / m->step[axis];
    if (!(from >= 0 && to < (double)m->count[axis]))
        return 0;
    *first = (size_t)from;
    *end = (size_t)to + 1;
    return brick_end(m, axis, *first) <= low && high <= brick_end(m, axis, *end);
}

graze_state interior_state(const interior *m, const box *b) {
    block part = {{0, 0, 0}, {1, 1, 1}};
    size_t at[3];
    if (!m->state)
        return GRAZE_STATE_ABSENT;
    for (int k = 0; k < m->dimension; k++)
        if (!find_bricks(&part.first[k], &part.end[k], m, k, b->low[k], b->high[k]))
            return GRAZE_STATE_ABSENT;
    graze_state state = (graze_state)*state_at(m, part.first);
    for (at[2] = part.first[2]; at[2] < part.end[2]; at[2]++)
        for (at[1] = part.first[1]; at[1] < part.end[1]; at[1]++)
            for (at[0] = part.first[0]; at[0] < part.end[0]; at[0]++)
                if (*state_at(m, at) != state)
                    return GRAZE_STATE_ABSENT;
    return state;
}
