/* Flats of space whose parameters are coordinates.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_FLAT_H
#define GRAZE_GENERATE_FLAT_H

#include <flint/fmpq_mpoly.h>

/** The points origin + s_0 direction[0] + ...: s_j is their coordinate axis[j]. */
typedef struct flat {
    int dimension, count; /* of space; of parameters */
    int axis[3];
    fmpq *origin, *direction[3]; /* one array of 12, borrowed by `direction` */
} flat;

/** All of space. */
void flat_init(flat *f, int dimension);
void flat_set(flat *to, const flat *from);
void flat_clear(flat *f);

/** The point of some parameters. */
void flat_point(fmpq *out, const flat *f, const fmpq *s);

/** The coordinates of its points, as polynomials of the parameters; `out` is initialised. */
void flat_coordinates(fmpq_mpoly_struct *out, const flat *f, const fmpq_mpoly_ctx_t ring);

/** Leave the part of a flat where a polynomial of degree 1 in its parameters is zero. */
void flat_cut(flat *f, const fmpq_mpoly_t linear, const fmpq_mpoly_ctx_t ring);

#endif
