/* The common part of two simplices at a time, given by its corners.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_COMMON_POINTS_H
#define GRAZE_COLLIDE_COMMON_POINTS_H

#include "questions/collide/placing.h"

/** A corner is a vertex of the moving simplex in the fixed one, a vertex of the fixed one in the
 * moving one, or a crossing of two edges inside both. */
typedef enum corner_kind { CORNER_MOVING = 0, CORNER_FIXED = 1, CORNER_EDGES = 2 } corner_kind;

/** A corner; `zero` are the sides of the moving and of the fixed simplex that hold it
 * (simplices.h). */
typedef struct common_corner {
    corner_kind kind;
    unsigned zero[2];
    int at[2]; /* the corner or (CORNER_EDGES) side of each simplex that it is on; -1: none */
} common_corner;

enum { MOST_CORNERS = 15 };

/** All corners of the common part of two closed simplices. `crossing`: an edge of one passes
 * through the other's relative interior from one side to the other. Then the solids' interiors meet
 * there, and corners may be missing (proofs/collision.md C109). */
typedef struct common_points {
    int crossing, count;
    common_corner item[MOST_CORNERS];
} common_points;

/** Find the corners at the placing's time. After a failure of the placing the result is invalid. */
void common_points_find(common_points *out, placing *p, near_pair simplices);

/** The vertices of side k of a triangle, or vertex k of a segment twice. */
void simplex_side(uint32_t out[2], const graze_solid *solid, uint32_t simplex, int k);
/** The vertices of side k with the lower number first, as a key of the edge. */
void simplex_edge(uint32_t out[2], const graze_solid *solid, uint32_t simplex, int k);

/** Do sides k and l of two triangles cross inside both? Their lines must lie in one plane.
 * @param plane signs of the moving triangle's corners at the fixed one's plane, then of the fixed
 * one's at the moving one's */
int edges_cross(placing *p, near_pair simplices, int k, int l, int plane[2][3]);

#endif
