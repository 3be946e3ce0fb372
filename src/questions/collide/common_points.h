/* Where two simplices meet at a time: the corners of what they have in common.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_COMMON_POINTS_H
#define GRAZE_COLLIDE_COMMON_POINTS_H

#include "questions/collide/placing.h"

/** A corner is a vertex of one of the two in the other one, or a crossing of two edges inside both.
 */
typedef enum corner_kind { CORNER_MOVING = 0, CORNER_FIXED = 1, CORNER_EDGES = 2 } corner_kind;

/** `zero` are the sides of the moving and the fixed simplex that hold the corner (simplices.h). */
typedef struct common_corner {
    corner_kind kind;
    unsigned zero[2];
    int at[2]; /* the corner or (CORNER_EDGES) side of each that it is; -1: none */
} common_corner;

enum { MOST_CORNERS = 15 };

/** All corners of the common part of two closed simplices; or `crossing`, if an edge of one passes
 * strictly through the other, from one side to the other: then both interiors meet there, and
 * corners may be missing (proofs/collision.md C109). */
typedef struct common_points {
    int crossing, count;
    common_corner item[MOST_CORNERS];
} common_points;

/** Find them at the placing's time. After a failure of the placing it means nothing. */
void common_points_find(common_points *out, placing *p, near_pair simplices);

/** Side k of a triangle of a side as its two vertices, or a segment's vertex k twice. */
void simplex_side(uint32_t out[2], const graze_solid *solid, uint32_t simplex, int k);
/** Ends of an edge, the lower number first: the edge's key. */
void simplex_edge(uint32_t out[2], const graze_solid *solid, uint32_t simplex, int k);

/**
 * Whether sides k and l of two triangles meet inside both, when their lines lie in one plane.
 * @param plane signs of each one's corners at the other one's plane, the moving one's first
 */
int edges_cross(placing *p, near_pair simplices, int k, int l, int plane[2][3]);

#endif
