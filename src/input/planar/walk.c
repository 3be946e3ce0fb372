/* Cuts boxes until few planes of a flat solid matter in each.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/planar/walk.h"

#include <math.h>
#include "base/context/scope.h"

/* Planes in a box that is not cut, and cuts across each axis that leave the number of planes as it
 * is, behind which a box is cut no further: the planes may meet in one point. */
enum { FEW = 16, LEVELS = 3 };

/* The sign of a plane's form in a closed box; 0 if it is not certain. Entries are within 2^-52 of
 * the exact ones, relative to these, or, if they are tiny, within 2^-1070; coordinates are below
 * 2^900. */
static signed char sign_in(const double *near, int d, const double *low, const double *high) {
    double least = near[3], most = near[3], size = fabs(near[3]);
    for (int i = 0; i < d; i++) {
        double a = near[i] * low[i], b = near[i] * high[i];
        least += fmin(a, b);
        most += fmax(a, b);
        size += fmax(fabs(a), fabs(b));
    }
    double error = 0x1p-48 * size + 0x1p-150;
    return least > error ? 1 : most < -error ? -1 : 0;
}

static graze_status push_marked(flat_walk *w, size_t from, size_t count, size_t offset) {
    for (size_t k = from; k < from + count; k++) {
        size_t number = w->stack.item[k];
        if (!w->matters[offset + number])
            continue;
        TRY(numbers_add(&w->stack, w->context, number, "the cells of a solid"));
        w->matters[offset + number] = 0;
    }
    return GRAZE_OK;
}

/* Push the planes and nodes of `all` that matter with the signs and truths at hand. The last node
 * does. */
static graze_status push_live(flat_live *out, flat_walk *w, const flat_live *all) {
    char *node_matters = w->matters + w->plane_count;
    node_matters[w->stack.item[all->node + all->nodes - 1]] = 1;
    for (size_t k = all->nodes; k-- > 0;) {
        size_t number = w->stack.item[all->node + k];
        const csg_node *n = &w->node[number];
        for (size_t i = n->first; node_matters[number] && i < n->first + n->count; i++) {
            size_t at = w->operand[i];
            if (n->operation == CSG_SIGN)
                w->matters[at] |= !w->sign[at];
            else
                node_matters[at] |= w->truth[at] == UNKNOWN;
        }
    }
    out->plane = w->stack.count;
    TRY(push_marked(w, all->plane, all->planes, 0));
    out->planes = w->stack.count - out->plane;
    out->node = w->stack.count;
    TRY(push_marked(w, all->node, all->nodes, w->plane_count));
    out->nodes = w->stack.count - out->node;
    return GRAZE_OK;
}

static graze_status walk(flat_walk *w, const flat_live *all, const double *low, const double *high,
                         int level);

/* Cut the box across its longest side and go on in both halves. */
static graze_status walk_halves(flat_walk *w, const flat_live *live, const double *low,
                                const double *high, int level) {
    double end[3] = {high[0], high[1], high[2]};
    int axis = 0;
    for (int i = 1; i < w->dimension; i++)
        if (high[i] - low[i] > high[axis] - low[axis])
            axis = i;
    end[axis] = low[axis] + (high[axis] - low[axis]) / 2;
    TRY(walk(w, live, low, end, level));
    double begin[3] = {low[0], low[1], low[2]};
    begin[axis] = end[axis];
    return walk(w, live, begin, high, level);
}

/* Whether the box is cut no further. `level` counts cuts that have left the number of planes. In a
 * large box the cuts that lead to its middle are free. */
static int is_done(const flat_walk *w, size_t planes, const double *low, const double *high,
                   int level) {
    double side = 0;
    int exponent;
    for (int i = 0; i < w->dimension; i++)
        side = fmax(side, high[i] - low[i]);
    frexp(side, &exponent);
    level -= exponent > 0 ? w->dimension * exponent : 0;
    return planes <= FEW || level > w->dimension * LEVELS;
}

/* Find the pieces in a box, of the planes and nodes that matter in the box around it. */
static graze_status walk(flat_walk *w, const flat_live *all, const double *low, const double *high,
                         int level) {
    flat_live live;
    size_t mark = w->stack.count;
    TRY(flat_spend(w, all->planes + all->nodes));
    for (size_t k = 0; k < all->planes; k++) {
        size_t p = w->stack.item[all->plane + k];
        w->sign[p] = sign_in(w->near + 4 * p, w->dimension, low, high);
    }
    if (flat_evaluate(w, all) == UNKNOWN && !w->unbounded) {
        TRY(push_live(&live, w, all));
        level = live.planes < all->planes ? 0 : level + 1;
        if (is_done(w, live.planes, low, high, level))
            TRY(flat_pieces_find(w, &live, low, high));
        else
            TRY(walk_halves(w, &live, low, high, level));
    }
    for (size_t k = 0; k < all->planes; k++)
        w->sign[w->stack.item[all->plane + k]] = 0;
    for (size_t k = 0; k < all->nodes; k++)
        w->truth[w->stack.item[all->node + k]] = UNKNOWN;
    w->stack.count = mark;
    return GRAZE_OK;
}

graze_status flat_walk_box(flat_walk *w, const double *low, const double *high) {
    flat_live all = {0, w->plane_count, w->plane_count, w->node_count};
    for (size_t k = 0; k < w->plane_count + w->node_count; k++)
        TRY(numbers_add(&w->stack, w->context, k < w->plane_count ? k : k - w->plane_count,
                        "the cells of a solid"));
    return walk(w, &all, low, high, 0);
}
