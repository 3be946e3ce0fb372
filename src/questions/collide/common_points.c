/* Corners of common parts, from signs of planes, sides and pairs of edges.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/collide/placing.h"

typedef struct finder {
    common_points *out;
    placing *p;
    near_pair simplices;
    int plane[2][3]; /* signs of each simplex's corners at the other's plane */
} finder;

static uint32_t corner_vertex(const finder *f, pair_side side, int k) {
    return placing_solid(f->p, side)->cut.item[simplex_of(f->simplices, side)].vertex[k];
}

void simplex_side(uint32_t out[2], const graze_solid *solid, uint32_t simplex, int k) {
    const uint32_t *vertex = solid->cut.item[simplex].vertex;
    out[0] = vertex[k];
    out[1] = solid->input.dimension == 3 ? vertex[(k + 1) % 3] : vertex[k];
}

void simplex_edge(uint32_t out[2], const graze_solid *solid, uint32_t simplex, int k) {
    uint32_t end[2];
    simplex_side(end, solid, simplex, k);
    out[0] = end[0] < end[1] ? end[0] : end[1];
    out[1] = end[0] < end[1] ? end[1] : end[0];
}

unsigned sides_around(int d, unsigned corners) {
    unsigned sides = 0;
    for (int k = 0; k < d; k++) {
        unsigned side = d == 3 ? 1u << k | 1u << (k + 1) % 3 : 1u << k;
        sides |= corners & ~side ? 0 : 1u << k;
    }
    return sides;
}

/* Set the signs of a simplex's corners at the other simplex's plane; returns 0 if all corners are
 * strictly on one side of that plane. */
static int look_at_plane(finder *f, pair_side side) {
    int d = f->p->pair->motion->dimension, above = 0, below = 0;
    pair_side other = (pair_side)!side;
    for (int k = 0; k < d; k++) {
        f->plane[side][k] = placing_plane_sign(f->p, other, simplex_of(f->simplices, other),
                                               corner_vertex(f, side, k));
        above += f->plane[side][k] > 0;
        below += f->plane[side][k] < 0;
    }
    return above < d && below < d && !f->p->status;
}

/* Add the corners of the simplex of one solid that are in the other simplex. */
static void add_vertex_corners(finder *f, pair_side side) {
    int d = f->p->pair->motion->dimension;
    pair_side other = (pair_side)!side;
    for (int k = 0; k < d && !f->p->status; k++) {
        common_corner c = {.kind = side == SIDE_MOVING ? CORNER_MOVING : CORNER_FIXED};
        if (f->plane[side][k] == 0 &&
            placing_inside(&c.zero[other], f->p, other, simplex_of(f->simplices, other),
                           corner_vertex(f, side, k))) {
            c.zero[side] = sides_around(d, 1u << k);
            c.at[side] = k;
            f->out->item[f->out->count++] = c;
        }
    }
}

/* Does side k of one simplex cross the line of side l of the other strictly between the ends of
 * side k, if both lines are coplanar? It does if these ends are on different sides of the other's
 * plane or, if they lie in that plane, of the line. */
static int passes(placing *p, near_pair simplices, pair_side side, int k, int l,
                  const int plane[3]) {
    pair_side other = (pair_side)!side;
    uint32_t end[2];
    int first = plane[k], second = plane[(k + 1) % 3];
    if (first == 0 && second == 0) {
        simplex_side(end, placing_solid(p, side), simplex_of(simplices, side), k);
        first = placing_side_sign(p, other, simplex_of(simplices, other), l, end[0]);
        second = placing_side_sign(p, other, simplex_of(simplices, other), l, end[1]);
    }
    return first * second < 0;
}

int edges_cross(placing *p, near_pair simplices, int k, int l, int plane[2][3]) {
    return passes(p, simplices, SIDE_MOVING, k, l, plane[SIDE_MOVING]) &&
           passes(p, simplices, SIDE_FIXED, l, k, plane[SIDE_FIXED]);
}

static int edges_sign(finder *f, int k, int l) {
    uint32_t moving[2], fixed[2];
    simplex_side(moving, f->p->pair->moving, f->simplices.moving, k);
    simplex_side(fixed, f->p->pair->fixed, f->simplices.fixed, l);
    return placing_edges_sign(f->p, moving, fixed);
}

/* Does edge k pass through the relative interior of the other triangle?
 * @param sign the signs of the edge's determinants with the triangle's three sides */
static int passes_through(const int plane[3], int k, const int sign[3]) {
    return plane[k] * plane[(k + 1) % 3] < 0 && sign[0] && sign[0] == sign[1] && sign[1] == sign[2];
}

/* An edge's position relative to the other triangle's plane. */
typedef enum edge_place { EDGE_BESIDE, EDGE_WITHIN, EDGE_THROUGH } edge_place;

static edge_place place_edge(const finder *f, pair_side side, int k) {
    int first = f->plane[side][k], second = f->plane[side][(k + 1) % 3];
    return first * second < 0 ? EDGE_THROUGH : first || second ? EDGE_BESIDE : EDGE_WITHIN;
}

/* Add the crossings of edges, and set `crossing`. Two lines are tested for being coplanar only if
 * one edge crosses the other's plane; if one lies in the other triangle's plane, the lines are
 * coplanar. */
static void add_edge_corners(finder *f) {
    int sign[3][3], turned[3][3];
    for (int k = 0; k < 3 && !f->p->status; k++)
        for (int l = 0; l < 3 && !f->p->status; l++) {
            edge_place a = place_edge(f, SIDE_MOVING, k), b = place_edge(f, SIDE_FIXED, l);
            int asked =
                (a == EDGE_THROUGH && b != EDGE_WITHIN) || (b == EDGE_THROUGH && a != EDGE_WITHIN);
            sign[k][l] = turned[l][k] = asked ? edges_sign(f, k, l) : 0;
            if (a && b && !sign[k][l] && edges_cross(f->p, f->simplices, k, l, f->plane))
                f->out->item[f->out->count++] =
                    (common_corner){CORNER_EDGES, {1u << k, 1u << l}, {k, l}};
        }
    for (int k = 0; k < 3 && !f->p->status; k++)
        f->out->crossing |= passes_through(f->plane[SIDE_MOVING], k, sign[k]) ||
                            passes_through(f->plane[SIDE_FIXED], k, turned[k]);
}

void common_points_find(common_points *out, placing *p, near_pair simplices) {
    finder f = {.out = out, .p = p, .simplices = simplices};
    *out = (common_points){.count = 0};
    if (!look_at_plane(&f, SIDE_MOVING) || !look_at_plane(&f, SIDE_FIXED))
        return;
    add_vertex_corners(&f, SIDE_MOVING);
    add_vertex_corners(&f, SIDE_FIXED);
    if (p->pair->motion->dimension == 3)
        add_edge_corners(&f);
    else
        out->crossing = f.plane[0][0] * f.plane[0][1] < 0 && f.plane[1][0] * f.plane[1][1] < 0;
}
