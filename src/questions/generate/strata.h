/* Points by stratum.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_GENERATE_STRATA_H
#define GRAZE_QUESTIONS_GENERATE_STRATA_H

#include <stddef.h>
#include "questions/generate/generate.h"

/* One rational time of a motion with the data for making contacts at that time: where body points
 * are, and how fast they leave their facets.
 *
 * For a point P and a facet's plane form n, F(u) = n . (X, W)(u) is the pullback along P's
 * trajectory. At a fixed u, F and its derivatives are affine in P, so also in the body point y with
 * P = M(u) y: F(u) = 0 for y on the facet, and F'(u) = 0 there says that the normal velocity of y
 * vanishes. */

void instant_init(instant *i, const graze_scene *scene, size_t piece, const fmpq_t u);
void instant_clear(instant *i);

/**
 * The derivative of order k of the pullback of a plane form along the trajectory of P = M(u) y, at
 * u, as a form in (y, 1) and times a positive number that depends on the instant and k alone.
 * @param[out] out d + 1 initialised integers
 * @param k 1 to INSTANT_DERIVATIVES
 */
void instant_pullback(fmpz *out, const instant *i, const fmpz *form, int k);

/** The gradient by P of the pullback of a plane form, times a positive number. If the form is
 * positive outside, the gradient is an outward normal of the moved facet. */
void instant_normal(fmpq *out, const instant *i, const fmpz *form);

/* Facets all of whose points are in contact at one time; a search at sampled times would miss that
 * time.
 */

/** Look for such facets among the planes of the solid: all planes, or if there are too many, planes
 * evenly spread among them. Facets whose time of contact is irrational are not found.
 */
graze_status specials_find(specials *out, graze_context *context, const graze_scene *scene);
void specials_clear(specials *list);

/** The derivative by u of the pullback of a plane form along the trajectory of the point P that is
 * M(u) y at this same u, as a polynomial in u: zero where the normal velocity of y is zero. */
void special_velocity(fmpz_poly_t out, const graze_scene *scene, size_t piece, const fmpz *form,
                      const fmpq *y);

/** Find the rational roots in (0, 1) of a polynomial and return their number; 0 if its degree is
 * above SPECIAL_ROOTS.
 */
enum { SPECIAL_ROOTS = 40 };
int special_roots(fmpq *out, const fmpz_poly_t p);

/** Draw a time for a contact of a stratum; NULL if the motion has none. */
const instant *stratum_instant(const struct graze_generator *g, graze_stratum stratum,
                               random_stream *r);

/** The order of a contact at u, from its pullback f: the multiplicity of the root u, or
 * GRAZE_ORDER_SLIDE if f is zero. f is overwritten by its derivatives. */
int order_of_root(fmpz_poly_t f, const fmpq_t u);

/** Does a contact of this order belong to the stratum? */
int stratum_takes_order(graze_stratum stratum, int order);

/** Set the point P = M(u) y of a body point, d + 1 homogeneous integers; 0, as soon as a coordinate
 * shows it, if the coordinates must be dyadic and are not. */
int sample_place(sample *out, const instant *when, const fmpz *y, int dyadic);

/** 0 if the generator makes only points whose coordinates are doubles and this point is not one. */
int sample_is_kept(sample *s, const struct graze_generator *g);

/* Query points of one stratum. */

/** The random stream of the search for levels; no row of a table uses it. */
#define LEVEL_STREAM (UINT64_C(5) << 61)

/** Try once for a contact of a stratum.
 * @param[out] made 0 if this try made none
 * @param[out] normal d rationals, an outward normal of the moved facet; may be NULL
 * @return GRAZE_OK for a polyhedron; for a curved solid also GRAZE_ELIMIT, GRAZE_ECANCELED,
 * GRAZE_ESYSTEM */
graze_status stratum_contact(int *made, sample *out, fmpq *normal, graze_context *context,
                             const struct graze_generator *g, graze_stratum stratum,
                             random_stream *r);

/** Try once for a point of any stratum except `level` and `rounded`; `made` and status as in
 * stratum_contact. */
graze_status stratum_try(int *made, sample *out, graze_context *context,
                         const struct graze_generator *g, graze_stratum stratum, random_stream *r);

/* Query points whose signed distance lies in a stated decade, on a stated side. */

/**
 * Find the levels of the scene: from the largest decade of |s| in which an `in` point is found down
 * to 1e-9 of the diagonal, on both sides. Levels among these in which no try finds a point become
 * the missing ones.
 * @return GRAZE_ELIMIT the scene is too large for computing distances; GRAZE_ECANCELED,
 * GRAZE_ESYSTEM
 */
graze_status levels_find(struct graze_generator *g, graze_context *context);

/** Try once for a point of one of the generator's levels: the point of a contact, displaced along
 * the normal, such that an enclosure of its s lies in the decade. *made is 0 if this try made none.
 */
graze_status level_try(int *made, sample *out, graze_context *context,
                       const struct graze_generator *g, random_stream *r);

/* Query points within an ulp of a contact. */

/** Try once for a point whose coordinates are doubles next to the coordinates of a contact. A
 * coordinate that is no double becomes one of its two neighbours; a double stays or becomes the
 * double before or after it. Among these points one on a randomly drawn side, inside or outside, is
 * taken if there is one, else any; `pmc` of the sample is the exact answer.
 * @param[out] made 0 if this try made none
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL
 */
graze_status rounded_try(int *made, sample *out, graze_context *context,
                         const struct graze_generator *g, random_stream *r);

/* Query points that touch a polyhedron or a polygon. */

/** Try once for a contact of a stratum as in stratum_contact; 0 if this try made none. */
int straight_contact(sample *out, fmpq *normal, const struct graze_generator *g,
                     graze_stratum stratum, random_stream *r);

/* Normal velocities of a simplex's corners at an instant, in doubles. */

/**
 * Is it certain that the first derivative of the pullback of a simplex's plane has one strict sign
 * at all corners of the simplex, so that it vanishes nowhere on the simplex (proofs/doubles.md
 * C64)?
 * @return 0 if the signs differ, or if that is not certain
 */
int velocity_has_one_sign(const instant *i, const graze_solid *solid, size_t simplex);

#endif
