/* Motions of plain pieces: integer polynomials in t, tested.
 * SPDX-License-Identifier: MIT
 */
#ifndef CHECK_MOTION_H
#define CHECK_MOTION_H

#include "poly.h"

/** Indices in a map: the entry in row i and column k of its 3 x 4 matrix has index 4 i + k, column
 * 3 is the translation; entry WEIGHT divides all of them. In the plane the map keeps z. */
enum { WEIGHT = 12, MAP = 13 };

typedef struct piece {
    mpq_t lo, hi;
    poly forward[MAP]; /* entries without a common factor; the weight is positive or 0 at lo */
    poly inverse[MAP]; /* the inverse map, reduced in the same way */
    poly det;          /* determinant of the 3 x 3 part of `forward` */
} piece;

typedef struct motion {
    int d;
    size_t count, room;
    piece *piece;
} motion;

/** Read a motion file of plain pieces, which must have this SHA-256. t0 < t1, the order of the
 * pieces and continuity are tested here; that weight and determinant are not zero, by
 * motion_check_signs. */
motion motion_read(const char *path, const char *sha256);

/** Append a piece with given lo, hi and `forward`, which may have common factors. Refutes a piece
 * that does not continue the piece before it. */
void motion_add(motion *m, const piece *next);
/** Refute the motion unless weight and determinant each have one strict sign on every closed
 * interval between neighbouring times. The times must go from t0 to t1 and contain all break
 * points. */
void motion_check_signs(const motion *m, mpq_t *times, size_t count);
/** Give up if the degree or a coefficient of p exceeds its limit. */
void motion_check_size(const poly *p);

#endif
