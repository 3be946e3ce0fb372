/* Charts of the degenerate strata.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_GENERATE_CHARTS_H
#define GRAZE_QUESTIONS_GENERATE_CHARTS_H

#include "questions/generate/generate.h"

/* Flats of space whose parameters are coordinates. */

/** All of space. */
void flat_init(flat *f, int dimension);
void flat_set(flat *to, const flat *from);
void flat_clear(flat *f);

/** The point of a flat that has the parameters s. */
void flat_point(fmpq *out, const flat *f, const fmpq *s);

/** The coordinates of the points of a flat as polynomials of the parameters; `out` is initialised.
 */
void flat_coordinates(fmpq_mpoly_struct *const *out, const flat *f, const fmpq_mpoly_ctx_t ring);

/** Reduce a flat to the part on which a polynomial of degree 1 in its parameters is zero. */
void flat_cut(flat *f, const fmpq_mpoly_t linear, const fmpq_mpoly_ctx_t ring);

/* Rational zeros of polynomials of degree at most 2. */

void quadratic_init(quadratic *q);
void quadratic_set(quadratic *to, const quadratic *from);
void quadratic_clear(quadratic *q);

/** Set q to a polynomial in the first `count` variables of a ring, with the start 0. */
void quadratic_read(quadratic *q, const fmpq_mpoly_t p, int count, const fmpq_mpoly_ctx_t ring);

/** Move the start to the place where the gradient is zero. Returns 0 and leaves q unchanged if
 * there is no such place. */
int quadratic_center(quadratic *q);

/** Move the start to a zero whose gradient is not zero; 0 if none is found. The search goes along
 * directions of small integers through the centre, then along lines beside it parallel to axes. */
int quadratic_find_zero(quadratic *q);

/** Find the direction of a line of zeros through a zero x of a cylinder or a cone in space; returns
 * 0 for other quadrics. */
int quadratic_ruling(fmpq *out, const quadratic *q, const fmpq *x);

/** Find the second zero on the line along `direction` through the start, which is a zero; returns 0
 * if there is none. */
int quadratic_other_zero(fmpq *out, const quadratic *q, const fmpq *direction);

/* Charts of rational common zeros of polynomials: flats, and quadrics in flats. */

void charts_clear(charts *list);

/** Append charts of zeros, in a flat, of a polynomial in the coordinates; other zeros may exist. */
graze_status charts_add_section(charts *list, const flat *place, const fmpq_mpoly_t p);

/** Append charts of common zeros of two polynomials, p irreducible. Zeros are found where p, a
 * factor of q, or a factor of the remainder of dividing one by the other is linear. */
graze_status charts_add_common(charts *list, const fmpq_mpoly_t p, const fmpq_mpoly_t q);

/** Append the singular point of the quadric of a polynomial of degree 2, if it has one. */
graze_status charts_add_singular(charts *list, const fmpq_mpoly_t p);

/**
 * Draw a point.
 * @param in the box in which the parameters of flats are drawn
 * @return 0 if this try made none
 */
int chart_draw(fmpq *point, const chart *from, random_stream *r, const csg_box *in);

/* Rational points of a curved solid's surfaces, of their edges and vertices, and of places on
 * surfaces where the normal velocity is zero at some instant. */

/** Look for rational points of a curved solid that has a box, in bounded time: if the solid has
 * many surfaces, not all pairs are searched for common points.
 * @return GRAZE_ECANCELED, GRAZE_ESYSTEM; atlas_clear in any case
 */
graze_status atlas_make(atlas *out, graze_context *context, const csg *solid,
                        const instant *instants, size_t count);
void atlas_clear(atlas *a);

/* Query points that touch a curved solid. */

/** Try once for a contact of a stratum as in stratum_contact, for a solid with an atlas. The point
 * is traced: it is made only if it has a contact at that time with the named primitive and its
 * answer is decided. */
graze_status curved_contact(int *made, sample *out, fmpq *normal, graze_context *context,
                            const struct graze_generator *g, graze_stratum stratum,
                            random_stream *r);

#endif
