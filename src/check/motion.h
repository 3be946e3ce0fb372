/* Motions: read, made into integer polynomials in t, and tested.
 * SPDX-License-Identifier: MIT
 */
#ifndef CHECK_MOTION_H
#define CHECK_MOTION_H

#include "json.h"
#include "poly.h"

/** An affine map with entries in Q(t), d rows of d + 1. */
typedef struct affine {
    int d;
    fraction at[3][4];
} affine;

void affine_identity(affine *a, int d); /* initialises */
void affine_clear(affine *a);
void affine_set(affine *out, const affine *a);
/** out = a after b */
void affine_compose(affine *out, const affine *a, const affine *b);

/** The map at time x, its entries constant; 0 where an entry has a pole. */
int affine_value(affine *out, const affine *a, const mpq_t x);
/** The inverse where det is not the zero polynomial; gives up where it is. */
void affine_inverse(affine *out, const affine *a);

typedef struct piece {
    mpq_t lo, hi;
    affine m;
    poly forward[3][4], forward_weight; /* m = forward / weight, without common factor */
    poly inverse[3][4], inverse_weight; /* the same of its inverse */
    poly det;                           /* of the d by d part of `forward` */
} piece;

typedef struct motion {
    int d;
    size_t count;
    piece *piece;
} motion;

/** Read a motion file's text. Tested here: t0 < t1, order, continuity. Poles and det are tested by
 * motion_check_signs. */
motion motion_read(const char *path, const char *text, size_t length);

/** The transform of a piece of a motion file (transform.c), read on the part from/n to (from+1)/n
 * of [lo, hi]. */
void transform_read(affine *out, const json *where, int d, const mpq_t lo, const mpq_t hi,
                    const mpq_t from, const mpq_t to, const char *path);
/** The numbers n of parts k/n that turns within a transform ask for. */
void transform_turns(const json *where, size_t **n, size_t *count, const char *path);
/** The rotation of a quaternion, four fractions. */
void rotation_of_quaternion(affine *out, const fraction q[4]);
/** An entry: an expression, or a JSON number; s may be NULL. */
void entry_read(fraction *out, const json *where, const fraction *s, const char *path);

#endif
