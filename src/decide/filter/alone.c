/* The simplices near the place of a crossing, tested for contacts in its window of time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Nearly all simplices miss a box around the curve in the window; for the others chord_meets and
 * meet_simplex show that the curve meets them at another time, or never. The bounds are those of
 * proofs/membership.md (C56).
 */
#include <math.h>
#include "decide/filter/search.h"

typedef struct neighbourhood {
    const curve *curve;
    const span *piece;
    const graze_solid *solid;
    uint32_t simplex;
    const meet_window *at;
    box around;
} neighbourhood;

/* Bound of the steps between neighbouring exact coefficients of coordinate i. */
static double greatest_step(const curve *c, const span *piece, int i) {
    const double *x = curve_coefficients(c, piece, i);
    double step = 0;
    for (int k = 0; k < piece->degree; k++)
        step = larger(step, fabs(x[k + 1] - x[k]));
    return step + 2 * piece->error[i];
}

/* A box that holds the curve at all times of the window; 0 if the weight's sign is not certain. */
static int bound_window(box *out, const curve *c, const span *piece, const meet_window *at) {
    double middle = 0.5 * (at->low + at->high), place[4], off[4];
    double half = FILTER_SLACK * larger(at->high - middle, middle - at->low);
    int d = c->dimension;
    curve_at(place, off, c, piece, middle);
    for (int i = 0; i <= d; i++)
        off[i] = FILTER_SLACK * (off[i] + half * piece->degree * greatest_step(c, piece, i));
    return place_bound(out, place, off, d);
}

/* Is it certain that the curve meets a simplex, unless it is the crossed one, at other times only?
 */
static int is_apart(const neighbourhood *n, uint32_t simplex) {
    const corners *corners = &n->solid->corners;
    size_t d = (size_t)n->curve->dimension;
    const double *corner = corners->at + simplex * d * d;
    meet_window other;
    if (simplex == n->simplex ||
        chord_meets(n->curve, n->piece, corner, corners->error) == CHORD_MISSES ||
        meet_simplex(&other, n->curve, n->piece, corner, corners->error) == MEET_NONE)
        return 1;
    return other.low > n->at->high || other.high < n->at->low;
}

static int all_apart(const neighbourhood *n, uint32_t index) {
    const tree_node *node = &n->solid->boxes.node[index];
    if (!box_meets(&node->box, &n->around))
        return 1;
    if (node->child)
        return all_apart(n, node->child) && all_apart(n, node->child + 1);
    return is_apart(n, node->simplex);
}

int crossing_is_alone(const curve *c, const span *piece, const graze_solid *solid, uint32_t simplex,
                      const meet_window *at) {
    neighbourhood n = {c, piece, solid, simplex, at, {{0, 0, 0}, {0, 0, 0}}};
    return bound_window(&n.around, c, piece, at) && flip(FLIP_ALONE, all_apart(&n, 0));
}
