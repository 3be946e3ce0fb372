/* Charts of the degenerate strata.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_GENERATE_CHARTS_H
#define GRAZE_QUESTIONS_GENERATE_CHARTS_H

#include <flint/fmpq_mpoly.h>
#include "base/context/context.h"
#include "base/number/random.h"
#include "input/csg/csg.h"
#include "questions/generate/generate.h"

/* Flats of space whose parameters are coordinates. */

/** All of space. */
void flat_init(flat *f, int dimension);
void flat_set(flat *to, const flat *from);
void flat_clear(flat *f);

/** The point of some parameters. */
void flat_point(fmpq *out, const flat *f, const fmpq *s);

/** The coordinates of its points, as polynomials of the parameters; `out` is initialised. */
void flat_coordinates(fmpq_mpoly_struct *const *out, const flat *f, const fmpq_mpoly_ctx_t ring);

/** Leave the part of a flat where a polynomial of degree 1 in its parameters is zero. */
void flat_cut(flat *f, const fmpq_mpoly_t linear, const fmpq_mpoly_ctx_t ring);

/* Rational zeros of polynomials of degree at most 2. */

void quadratic_init(quadratic *q);
void quadratic_set(quadratic *to, const quadratic *from);
void quadratic_clear(quadratic *q);

/** Read the polynomial in the first `count` variables of a ring, from the start 0. */
void quadratic_read(quadratic *q, const fmpq_mpoly_t p, int count, const fmpq_mpoly_ctx_t ring);

/** Start from the place where the gradient is zero; 0 if there is none, and q stays. */
int quadratic_center(quadratic *q);

/** Start from a zero with a gradient; 0 if the search finds none: along directions of small
 * integers through the centre, and along axes beside it. */
int quadratic_find_zero(quadratic *q);

/** The direction of a line of zeros through a zero x: of a cylinder or a cone in space; else 0. */
int quadratic_ruling(fmpq *out, const quadratic *q, const fmpq *x);

/** Find the second zero on the line along `direction` through the start, a zero; 0 without one. */
int quadratic_other_zero(fmpq *out, const quadratic *q, const fmpq *direction);

/* Rational points that polynomials have in common: flats, and quadrics in flats. */

void charts_clear(charts *list);

/** Append charts of the zeros that are found, in a flat, of a polynomial of the coordinates. */
graze_status charts_add_section(charts *list, const flat *place, const fmpq_mpoly_t p);

/** Append charts of common zeros of two polynomials, p irreducible: of those found because p, a
 * factor of q, or a factor of the remainder of dividing one by the other is linear. */
graze_status charts_add_common(charts *list, const fmpq_mpoly_t p, const fmpq_mpoly_t q);

/** Append the singular point of the zeros of a polynomial of degree 2, if there is one. */
graze_status charts_add_singular(charts *list, const fmpq_mpoly_t p);

/**
 * Draw a point.
 * @param in the box in which points of flats are drawn
 * @return 0 if this try made none
 */
int chart_draw(fmpq *point, const chart *from, random_stream *r, const csg_box *in);

/* Rational points of a curved solid's surfaces, of their edges and vertices, and of the places of
 * surfaces whose normal velocity is zero at a time. */

/** Look for rational points of a curved solid that has a box, in bounded time: if it has many
 * surfaces, not for common points of all pairs.
 * @return GRAZE_ECANCELED, GRAZE_ESYSTEM; atlas_clear in any case
 */
graze_status atlas_make(atlas *out, graze_context *context, const csg *solid,
                        const instant *instants, size_t count);
void atlas_clear(atlas *a);

/* Query points that touch a curved solid. */

/** As stratum_contact, of a solid with an atlas. The point is traced: it has a contact at the time,
 * with the primitive that is named, and no state that is undecided. */
graze_status curved_contact(int *made, sample *out, fmpq *normal, graze_context *context,
                            const struct graze_generator *g, graze_stratum stratum,
                            random_stream *r);

#endif
