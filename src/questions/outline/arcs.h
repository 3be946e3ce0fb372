/* Candidate curves, their equations and their cuts.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_OUTLINE_ARCS_H
#define GRAZE_QUESTIONS_OUTLINE_ARCS_H

#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_poly.h>
#include "questions/outline/bracket.h"

/* Variables of forms: two coordinates, and one that is eliminated. */
enum { FORM_X, FORM_Y, FORM_S, FORM_VARIABLES };

/** Find all candidates of the boundary, and the points at which a path or an envelope rests
 * (proofs/outline.md C134). */
graze_status outline_candidates(graze_outline *o, graze_context *context);

/** Set the outline's covering, and leave out the candidates, and parts of them, that it covers. */
graze_status outline_cover(graze_outline *o, graze_context *context);
graze_status outline_open_parts(graze_outline *o, graze_context *context);
void covering_clear(covering *v);
/** Is all of a box, near a piece of the motion, inside the moving solid at one time (for an
 * unsweep: outside it)? 0 where it is not told (proofs/outline.md C146). */
int outline_covers(const graze_outline *o, const box *x, size_t piece);

/** Find the equations of all curves (C135), and the boxes and groups of the curves. */
graze_status outline_equations(graze_outline *o, graze_context *context);

/** Cut all curves (C136). */
graze_status outline_cuts(graze_outline *o, graze_context *context);

/** Append a rational point, two coordinates, to a list of such points. */
graze_status outline_keep_point(fmpq **list, size_t *count, size_t *capacity,
                                graze_context *context, const fmpq *point);
/** Append an empty curve; the pointer is valid until the next one. */
graze_status outline_curve_append(outline_curve **out, graze_outline *o, graze_context *context);
void outline_curve_clear(outline_curve *c);
/** The polynomial whose roots are the parameters at which a coordinate has a value. */
void outline_curve_level(fmpz_poly_t out, const outline_curve *c, int coordinate, const fmpq_t at);
/** The polynomial whose roots are the parameters at which the curve, not slanted, passes a point.
 */
void outline_curve_at_point(fmpz_poly_t out, const outline_curve *c, const fmpq *point);
/** The rational point of a curve that is not slanted. */
void outline_curve_at(fmpq *point, const outline_curve *c, const fmpq_t s);
/** The degree of the curve's polynomials. */
slong outline_curve_degree(const outline_curve *c);
/** Bound a place of a curve, or a part of it. */
graze_status outline_place_box(box *out, graze_context *context, outline_curve *c, algebraic *s);
graze_status outline_curve_box(box *out, graze_context *context, outline_curve *c, algebraic *from,
                               algebraic *to);
/** A place of a curve as a box: its corners with the least and with the greatest coordinates, four
 * rationals. */
graze_status outline_curve_corners(fmpq *corner, graze_context *context, outline_curve *c,
                                   algebraic *s, ulong places);
/** The empty box of the plane. */
void box_empty(box *out);
/** Widen a box to hold a rational point of the plane. */
void box_add_point(box *out, const fmpq *point);

/* Numbers between two others. */

/** Append the roots of p between two numbers, or a little outside. */
graze_status roots_about(algebraic_list *list, graze_context *context, const fmpz_poly_t p,
                         const algebraic *from, const algebraic *to);
/** Append the roots of p strictly between two numbers. */
graze_status roots_between(algebraic_list *list, graze_context *context, const fmpz_poly_t p,
                           algebraic *from, algebraic *to);
/** Is a number strictly between two others? */
graze_status number_between(int *out, graze_context *context, algebraic *low, algebraic *x,
                            algebraic *high);

/* Forms: integer polynomials in FORM_X and FORM_Y. */

/** The form, homogeneous of the degree, at x = (X, Y, W). */
void form_pullback(fmpz_poly_t out, const fmpz_mpoly_t form, slong degree,
                   const fmpz_poly_struct *x, const fmpz_mpoly_ctx_t ring);
/** The form of an equation at a point moved along an axis: a polynomial of the distance. */
void form_on_line(fmpz_poly_t out, const graze_outline *o, const outline_equation *e,
                  const fmpq *point, int axis);
/** A form without the variable that vanishes where both forms do: one of them, or their resultant.
 */
graze_status form_eliminate(fmpz_mpoly_t out, graze_context *context, const fmpz_mpoly_t a,
                            const fmpz_mpoly_t b, int variable, const fmpz_mpoly_ctx_t ring);

/* Numbers that are images of algebraic numbers. */

/** The minimal polynomial of a number, which is irrational unless the polynomial is linear. */
void number_minimal(fmpz_poly_t out, const algebraic *x);
/** Let a number's polynomial be its minimal one; a rational number is known as such then. */
void number_reduce(algebraic *x);
/** A polynomial that vanishes at num/den of all roots of q, den not 0 there. */
void image_polynomial(fmpz_poly_t out, const fmpz_poly_t q, const fmpz_poly_t num,
                      const fmpz_poly_t den);
/** A coordinate of a curve at a parameter, by its minimal polynomial. */
graze_status outline_coordinate(algebraic *out, const graze_outline *o, graze_context *context,
                                outline_curve *c, algebraic *s, int axis);
/** The parameter, x, of a slanted line at which y has a value. */
graze_status outline_line_crossing(algebraic *out, const graze_outline *o, graze_context *context,
                                   outline_curve *c, const fmpq_t value);

#endif
