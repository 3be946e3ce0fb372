/* Motions of plain pieces: integer polynomials in t, tested.
 * SPDX-License-Identifier: MIT
 */
#ifndef CHECK_MOTION_H
#define CHECK_MOTION_H

#include "poly.h"

/** Entry (i, k) of a map's 3 rows of 4 is at[4 i + k], that of its translation is at[4 i + 3]; all
 * are divided by the weight. In the plane z stands still. */
enum { WEIGHT = 12, MAP = 13 };

typedef struct piece {
    mpq_t lo, hi;
    poly forward[MAP]; /* without a factor common to all; the weight is positive at lo or 0 */
    poly inverse[MAP]; /* the same of its inverse */
    poly det;          /* of the 3 by 3 part of `forward` */
} piece;

typedef struct motion {
    int d;
    size_t count, room;
    piece *piece;
} motion;

/** Read a motion file of plain pieces, of this SHA-256. t0 < t1, order and continuity are tested;
 * poles and det by motion_check_signs. */
motion motion_read(const char *path, const char *sha256);

/** Take in the next piece; its lo, hi and `forward` are given, common factors included. Refutes
 * one that does not go on from the piece before it. */
void motion_add(motion *m, const piece *next);
/** The denominator and the determinant have one strict sign between neighbouring times, which go
 * from t0 to t1 and take in all break points; or refutes. */
void motion_check_signs(const motion *m, mpq_t *times, size_t count);
/** Gives up on a degree or coefficients past the caps. */
void motion_check_size(const poly *p);

#endif
