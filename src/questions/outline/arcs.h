/* Candidate curves, their equations and their cuts.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_OUTLINE_ARCS_H
#define GRAZE_QUESTIONS_OUTLINE_ARCS_H

#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_poly.h>
#include "questions/outline/outline.h"
#include "questions/outline/bracket.h"

/* Variables of forms: two coordinates, and one that is eliminated. */
enum { FORM_X, FORM_Y, FORM_S, FORM_VARIABLES };

/** Find all candidates of the boundary, and the points at which a path or an envelope rests
 * (proofs/outline.md C131). */
graze_status outline_candidates(graze_outline *o, graze_context *context);

/** Find the equations of all curves (C132), and the boxes and groups of the curves. */
graze_status outline_equations(graze_outline *o, graze_context *context);

/** Cut all curves (C133). */
graze_status outline_cuts(graze_outline *o, graze_context *context);

/** Append an empty curve; the pointer is valid until the next one. */
graze_status outline_curve_append(outline_curve **out, graze_outline *o, graze_context *context);
/** Take back the last curve. */
void outline_curve_drop_last(graze_outline *o);
void outline_curve_clear(outline_curve *c);
/** Divide by the common factor of the three polynomials; returns 1 if the curve is one point. */
int outline_curve_reduce(outline_curve *c);
/** The polynomial whose roots are the parameters at which a coordinate has a value. */
void outline_curve_level(fmpz_poly_t out, const outline_curve *c, int coordinate, const fmpq_t at);
/** The polynomial whose roots are the parameters at which the curve, not slanted, piece_passes a
 * point.
 */
void outline_curve_at_point(fmpz_poly_t out, const outline_curve *c, const fmpq *point);
/** The degree of the curve's polynomials. */
slong outline_curve_degree(const outline_curve *c);
/** Bound a part of a curve. */
graze_status outline_curve_box(box *out, graze_context *context, outline_curve *c, algebraic *from,
                               algebraic *to);
/** A dyadic interval that holds both numbers. */
void interval_of(dyadic_interval *out, const algebraic *from, const algebraic *to);

/* Forms: integer polynomials in FORM_X and FORM_Y. */

/** Add p(variable) x^i y^j, `sign` times, to a form. */
void form_add(fmpz_mpoly_t form, const fmpz_poly_t p, int variable, ulong i, ulong j, slong sign,
              const fmpz_mpoly_ctx_t ring);
/** A form of one variable as a polynomial. */
void form_to_poly(fmpz_poly_t out, const fmpz_mpoly_t form, int variable,
                  const fmpz_mpoly_ctx_t ring);
/** The form, homogeneous of the degree, at x = (X, Y, W). */
void form_pullback(fmpz_poly_t out, const fmpz_mpoly_t form, slong degree,
                   const fmpz_poly_struct *x, const fmpz_mpoly_ctx_t ring);
/** A form without the variable that vanishes where both forms do: one of them, or their resultant.
 */
graze_status form_eliminate(fmpz_mpoly_t out, graze_context *context, const fmpz_mpoly_t a,
                            const fmpz_mpoly_t b, int variable, const fmpz_mpoly_ctx_t ring);

/* Numbers that are images of algebraic numbers. */

/** out = x y' - x' y. */
void slope_product(fmpz_poly_t out, const fmpz_poly_t x, const fmpz_poly_t y);
/** The minimal polynomial of a number, which is irrational unless the polynomial is linear. */
void number_minimal(fmpz_poly_t out, const algebraic *x);
/** Let a number's polynomial be its minimal one; a rational number is known as such then. */
void number_reduce(algebraic *x);
/** A polynomial that vanishes at num/den of all roots of q, den not 0 there. */
void image_polynomial(fmpz_poly_t out, const fmpz_poly_t q, const fmpz_poly_t num,
                      const fmpz_poly_t den);
/** The number (num/den)(x), by its minimal polynomial. */
graze_status image_number(algebraic *out, graze_context *context, const fmpz_poly_t num,
                          const fmpz_poly_t den, algebraic *x);
/** If the bracket holds exactly one root of p, set the number to it; p has no repeated root. */
graze_status number_in_bracket(int *found, algebraic *out, graze_context *context,
                               const fmpz_poly_t p, const bracket *where, ulong places);

#endif
