/* The state in which the nodes of a curved solid are read.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CSG_CSG_READER_H
#define GRAZE_CSG_CSG_READER_H

#include <flint/fmpq_mat.h>
#include "input/csg/csg_build.h"
#include "input/motion/json_tree.h"

/** Coordinates of a point in the frame of the node at hand, as linear forms of those of the solid;
 * the way back; and room for the polynomials of one primitive. */
typedef struct csg_reader {
    csg_builder build;
    int dimension;
    fmpq_mat_t place; /* from the frame of the node to that of the solid, homogeneous */
    csg_box box;      /* of the last node, in the frame of the solid (csg_bound.h) */
    fmpq_mpoly_struct coordinate[3];
    fmpq_mpoly_struct from[3];                /* the point minus a primitive's own point */
    fmpq_mpoly_struct square, along, f, term; /* |from|^2, axis . from, the polynomial, a summand */
} csg_reader;

/** Read the value of a primitive's key, after csg_add_primitive. */
typedef graze_status csg_primitive_reader(size_t *node, csg_reader *r, const json *value);

/** A reader in the frame of the solid, whose builder and dimension are set. */
void csg_reader_init(csg_reader *r);
void csg_reader_clear(csg_reader *r);

/** The members of a primitive: the first `needed` of `count` must be there. */
graze_status csg_read_members(const json **out, csg_reader *r, const json *value,
                              const char *const *names, size_t count, size_t needed);

/** GRAZE_EINPUT in the plane, for a primitive of space. */
graze_status csg_in_space(csg_reader *r, const json *value);

/** A number, as entry_number; one that is written as a token is no calculation. */
graze_status csg_read_number(fmpq_t out, csg_reader *r, const json *value);

/** `count` numbers. */
graze_status csg_read_vector(fmpq *out, csg_reader *r, const json *value, size_t count);

/** out = sum factor[i] x[i] - constant, over d polynomials. */
void csg_linear_form(fmpq_mpoly_t out, csg_reader *r, const fmpq *factor,
                     const fmpq_mpoly_struct *x, const fmpq_t constant);

/** f <= 0 of r->f, or f >= 0 if `other`. */
graze_status csg_add_side(size_t *node, csg_reader *r, int other);

#endif
