/* Groups of pieces, each half as long as its parent, bounded by the segment between the matrices at
 * their ends and the distance from it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/bounds/bounds.h"

#include <math.h>
#include <stdlib.h>

/* Matrix k of a piece's control polygon: the matrices of its maps are means of these. 0 if there is
 * no bound: its weight is too small, or an entry beyond CARRIER_REACH. */
static int control_matrix(double *out, const carrier *piece, int entries, int k) {
    if (!piece->usable || !(piece->weight[k] > CARRIER_LEAST_WEIGHT))
        return 0;
    for (int e = 0; e < entries; e++) {
        out[e] = piece->entry[e * (piece->degree + 1) + k] / piece->weight[k];
        if (!(fabs(out[e]) <= CARRIER_REACH))
            return 0;
    }
    return 1;
}

/* The s at which first + s (last - first) is nearest to a matrix. Bounds hold for any s in [0, 1];
 * this one makes them small. */
static double share_of(const piece_group *g, const double *matrix, int entries) {
    double along = 0, square = 0;
    for (int e = 0; e < entries; e++) {
        double step = g->last[e] - g->first[e];
        along += (matrix[e] - g->first[e]) * step;
        square += step * step;
    }
    double s = square > 0 ? along / square : 0;
    return s > 0 ? smaller(s, 1) : 0;
}

static void bound_group(course *c, piece_group *g, size_t count) {
    const carrier *first = &c->piece[g->piece], *last = first + count - 1;
    double matrix[POINT_MAP_ENTRIES];
    int entries = c->dimension * (c->dimension + 1);
    g->bounded = control_matrix(g->first, first, entries, 0) &&
                 control_matrix(g->last, last, entries, last->degree);
    for (int e = 0; e < entries; e++)
        g->off[e] = 0;
    for (const carrier *p = first; p <= last && g->bounded; p++)
        for (int k = 0; k <= p->degree && g->bounded; k++) {
            g->bounded = control_matrix(matrix, p, entries, k);
            double s = g->bounded ? share_of(g, matrix, entries) : 0;
            for (int e = 0; e < entries && g->bounded; e++) {
                double chord = g->first[e] + s * (g->last[e] - g->first[e]);
                double size = fabs(matrix[e]) + fabs(g->first[e]) + fabs(g->last[e]);
                double off = fabs(matrix[e] - chord) + 0x1p-46 * size + FILTER_FLOOR;
                g->off[e] = larger(g->off[e], off);
            }
        }
}

static void make_group(course *c, size_t index, size_t piece, size_t count) {
    piece_group *g = &c->group[index];
    g->piece = (uint32_t)piece;
    g->child = 0;
    g->bounded = 0;
    if (count == 1)
        return;
    bound_group(c, g, count);
    g->child = (uint32_t)c->group_count;
    c->group_count += 2;
    make_group(c, g->child, piece, count / 2);
    make_group(c, g->child + 1, piece + count / 2, count - count / 2);
}

int course_make(course *out, const graze_motion *motion, graze_operation operation) {
    size_t n = motion->piece_count;
    *out = (course){.dimension = motion->dimension, .group_count = 1};
    out->piece = calloc(n, sizeof *out->piece);
    out->group = calloc(2 * n - 1, sizeof *out->group);
    int made = out->piece && out->group;
    for (; made && out->piece_count < n; out->piece_count++) {
        const motion_piece *from = &motion->piece[out->piece_count];
        carrier *to = &out->piece[out->piece_count];
        made = carrier_make(to, motion_tracing(from, operation));
        out->degree = to->degree > out->degree ? to->degree : out->degree;
    }
    if (made)
        make_group(out, 0, 0, n);
    else
        course_clear(out);
    return made;
}

void course_clear(course *c) {
    for (size_t k = 0; k < c->piece_count; k++)
        carrier_clear(&c->piece[k]);
    free(c->piece);
    free(c->group);
    *c = (course){.piece_count = 0};
}
