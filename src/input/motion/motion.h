/* Checked motions: continuous, piecewise rational, invertible on all of [t0, t1].
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * On piece k the motion's parameter is t = lo + (hi - lo) u with u in [0, 1]. Both the motion and
 * its inverse are kept as point maps P -> N(u) (P, 1) / W(u) with integer polynomials in u
 * (proofs/claims.md C9).
 */
#ifndef GRAZE_MOTION_MOTION_H
#define GRAZE_MOTION_MOTION_H

#include <flint/fmpq.h>
#include <flint/fmpz_poly.h>
#include "base/context/context.h"

/** dimension * (dimension + 1), at most. */
enum { POINT_MAP_ENTRIES = 12 };

/**
 * A point map with polynomial entries: image i of a point is (sum_j entry[i*(d+1)+j] P_j +
 * entry[i*(d+1)+d]) / weight. Invariant: weight > 0 on all of [0, 1]; the entries and the weight
 * have no common factor in Z[u].
 */
typedef struct point_map {
    int dimension;
    fmpz_poly_struct entry[POINT_MAP_ENTRIES]; /* dimension*(dimension+1) in use, row by row */
    fmpz_poly_t weight;
} point_map;

typedef struct motion_piece {
    fmpq_t lo, hi;     /* in the motion's parameter t; lo < hi */
    unsigned long row; /* the line of the log that it comes from; 0: none is given */
    point_map forward; /* M(t) */
    point_map inverse; /* M(t)^-1 */
} motion_piece;

struct graze_motion {
    int dimension;
    size_t piece_count; /* at least 1; hi of one piece is lo of the next, and M agrees there */
    motion_piece *piece;
    int has_rows;             /* a piece has a row */
    unsigned char sha256[32]; /* of the file's or text's bytes */
};

/** The map that carries query points: M(t)^-1 for the sweep, M(t) for the unsweep. */
const point_map *motion_tracing(const motion_piece *piece, graze_operation operation);
/** The inverse of that map, which carries the standing solid's points to the query points' space.
 */
const point_map *motion_placing(const motion_piece *piece, graze_operation operation);

void point_map_init(point_map *map, int dimension);
void point_map_clear(point_map *map);

/** The value at u = numerator/denominator of a point map as an affine map with rational entries,
 * d*(d+1) initialised fmpq. */
void point_map_at(fmpq *out, const point_map *map, const fmpq_t u);

/** The sign of the determinant of an affine map as point_map_at gives it. */
int affine_orientation(const fmpq *map, int d);

void motion_destroy(graze_motion *motion);

#endif
