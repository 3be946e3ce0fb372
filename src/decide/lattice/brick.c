/* A brick is halved along its axes until all points of a cell have one membership, or the cell is
 * small and its points are asked one by one. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/lattice/lattice.h"

#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"

/* Points of cells with fewer points than this along every axis are asked one by one. */
enum { LEAST_SIDE = 2 };

typedef struct bricklayer {
    unsigned char *pmc;
    cell_asker ask;
    const brick *whole;
    int dimension;
    fmpq *exact[3]; /* coordinates of the brick's points along each axis, and their bounds */
    double low[3][BRICK_SIDE_PLANE], high[3][BRICK_SIDE_PLANE];
} bricklayer;

/* Make the cell that holds the points of a part. */
static void make_cell(point_box *out, const bricklayer *b, const brick *points) {
    memset(out, 0, sizeof *out);
    for (int k = 0; k < b->dimension; k++) {
        double low = b->low[k][points->first[k] - b->whole->first[k]];
        double high = b->high[k][points->end[k] - 1 - b->whole->first[k]];
        out->centre[k] = 0.5 * (low + high);
        out->half[k] =
            FILTER_SLACK * larger(high - out->centre[k], out->centre[k] - low) + FILTER_FLOOR;
    }
}

/* The byte of a point of the brick. */
static unsigned char *byte_of(const bricklayer *b, const size_t at[3]) {
    size_t index = 0;
    for (int k = 2; k >= 0; k--)
        index = index * (b->whole->end[k] - b->whole->first[k]) + at[k] - b->whole->first[k];
    return b->pmc + index;
}

/* Go to the next point of a part of the brick; 0 after the last one. */
static int next_place(size_t at[3], const brick *part) {
    for (int k = 0; k < 3; k++) {
        if (++at[k] < part->end[k])
            return 1;
        at[k] = part->first[k];
    }
    return 0;
}

/* Ask one point; if it meets a limit or a fault, so will the caller that asks it alone. */
static graze_status ask_point(bricklayer *b, const size_t at[3]) {
    fmpq point[3];
    graze_trace trace;
    for (int k = 0; k < b->dimension; k++)
        point[k] = b->exact[k][at[k] - b->whole->first[k]];
    graze_status status = classify_point(&trace, b->ask.context, b->ask.scene,
                                         (query_point){.rational = point}, TRACE_PMC_BESIDE);
    if (status)
        return status == GRAZE_ECANCELED || status == GRAZE_ESYSTEM ? status : GRAZE_OK;
    *byte_of(b, at) = (unsigned char)trace.verdict.pmc;
    trace_clear(&trace);
    return GRAZE_OK;
}

/* Is a point certainly joined with an anchor? */
static int point_joins(bricklayer *b, const size_t at[3], const anchors *near) {
    brick alone = {{at[0], at[1], at[2]}, {at[0] + 1, at[1] + 1, at[2] + 1}};
    point_box point;
    if (!near->count)
        return 0;
    make_cell(&point, b, &alone);
    return point_box_begin(&b->ask.tube, &b->ask.scene->filter, &point) &&
           cell_joins(&b->ask, &point, near);
}

static graze_status ask_points(bricklayer *b, const brick *part, const anchors *near) {
    size_t at[3];
    memcpy(at, part->first, sizeof at);
    do
        if (point_joins(b, at, near))
            *byte_of(b, at) = (unsigned char)cell_membership_proved(&b->ask);
        else
            TRY(ask_point(b, at));
    while (next_place(at, part));
    return GRAZE_OK;
}

static void fill_part(bricklayer *b, const brick *part, graze_pmc pmc) {
    size_t at[3];
    memcpy(at, part->first, sizeof at);
    do
        *byte_of(b, at) = (unsigned char)pmc;
    while (next_place(at, part));
}

/* Take one of the eight parts into which halving along each axis cuts a part; bit k of `half` is
 * its side along axis k. 0 if it is empty. */
static int take_half(brick *out, const brick *part, int half) {
    *out = *part;
    for (int k = 0; k < 3; k++) {
        size_t middle = part->first[k] + (part->end[k] - part->first[k] + 1) / 2;
        if (half >> k & 1)
            out->first[k] = middle;
        else
            out->end[k] = middle;
        if (out->first[k] == out->end[k])
            return 0;
    }
    return 1;
}

static graze_status decide_part(bricklayer *b, const brick *part, const anchors *around) {
    size_t most = 0;
    anchors near = *around;
    point_box points;
    for (int k = 0; k < 3; k++)
        most = part->end[k] - part->first[k] > most ? part->end[k] - part->first[k] : most;
    if (most < LEAST_SIDE)
        return ask_points(b, part, &near);
    make_cell(&points, b, part);
    graze_pmc pmc = cell_decide(&b->ask, &points, &near, most <= LEAST_SIDE);
    if (pmc != GRAZE_PMC_NONE) {
        fill_part(b, part, pmc);
        return GRAZE_OK;
    }
    if (most <= LEAST_SIDE)
        return ask_points(b, part, &near);
    for (int half = 0; half < 8; half++) {
        brick child;
        if (take_half(&child, part, half))
            TRY(decide_part(b, &child, &near));
    }
    return GRAZE_OK;
}

/* Compute the coordinates of the brick's points, and bounds of them. */
static void set_coordinates(bricklayer *b, const lattice *l) {
    for (int k = 0; k < b->dimension; k++) {
        size_t n = b->whole->end[k] - b->whole->first[k];
        b->exact[k] = _fmpq_vec_init((slong)n);
        for (size_t i = 0; i < n; i++) {
            lattice_coordinate(b->exact[k] + i, l, k, b->whole->first[k] + i);
            rational_bounds(&b->low[k][i], &b->high[k][i], b->exact[k] + i);
        }
    }
}

graze_status brick_decide(unsigned char pmc[BRICK_POINTS], graze_context *context,
                          const graze_scene *scene, const lattice *l, const brick *points) {
    bricklayer b = {.pmc = pmc, .whole = points, .dimension = l->dimension};
    memset(pmc, 0, BRICK_POINTS);
    TRY(context_poll(context));
    cell_asker_init(&b.ask, context, scene);
    set_coordinates(&b, l);
    anchors none = {.count = 0};
    graze_status status =
        context->exact_only ? ask_points(&b, points, &none) : decide_part(&b, points, &none);
    for (int k = 0; k < l->dimension; k++)
        _fmpq_vec_clear(b.exact[k], (slong)(points->end[k] - points->first[k]));
    cell_asker_clear(&b.ask);
    return status;
}
