/* Affine maps of E^d whose entries are rational functions of one parameter u.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MOTION_AFFINE_H
#define GRAZE_MOTION_AFFINE_H

#include "input/motion/motion.h"
#include "input/motion/quotient.h"

enum { AFFINE_ENTRIES = POINT_MAP_ENTRIES };

/** P -> A P + b: d rows of d + 1 entries, b last in each row. */
typedef struct affine {
    int dimension;
    fmpz_poly_q_t entry[AFFINE_ENTRIES]; /* all initialised, dimension*(dimension+1) in use */
} affine;

/** The identity of E^d. */
void affine_init(affine *a, int dimension);
void affine_clear(affine *a);
void affine_identity(affine *a);
void affine_set(affine *a, const affine *b);
int affine_equal(const affine *a, const affine *b);

/** The entry of row i and column j, both from 0. */
fmpz_poly_q_struct *affine_at(affine *a, int i, int j);
const fmpz_poly_q_struct *affine_get(const affine *a, int i, int j);

/** out = a after b, that is, the matrix a b. `out` may be either. */
void affine_multiply(calculation *c, affine *out, const affine *a, const affine *b);
/** Put `center` (d functions) in the place of the origin: b += center - A center. */
void affine_about(calculation *c, affine *a, fmpz_poly_q_t *center);
/** out(u) = a(low + (high - low) u). `out` is not `a`. */
void affine_substitute(calculation *c, affine *out, const affine *a, const fmpq_t low,
                       const fmpq_t high);
/** The constant map that a is at u, where it has no pole. */
void affine_at_time(affine *out, const affine *a, const fmpq_t u);

#endif
