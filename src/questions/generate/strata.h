/* Points by stratum.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_GENERATE_STRATA_H
#define GRAZE_QUESTIONS_GENERATE_STRATA_H

#include <stddef.h>
#include "base/number/random.h"
#include "decide/scene/scene.h"
#include "graze/generate.h"
#include "input/solid/solid.h"
#include "input/validate/validate.h"
#include "questions/generate/generate.h"

/* One rational time of a motion with what is needed to make contacts at it: where body points are,
 * and how fast they leave their facets.
 *
 * For a point P and a facet's plane form n, F(u) = n . (X, W)(u) is the pullback along P's
 * trajectory. At a fixed u it and its derivatives are affine in P, so in the body point y with P =
 * M(u) y: F(u) = 0 for y on the facet, and F'(u) = 0 there says that the normal velocity of y
 * vanishes. */

void instant_init(instant *i, const graze_scene *scene, size_t piece, const fmpq_t u);
void instant_clear(instant *i);

/** P = M(u) y. */
void instant_move(fmpq *out, const instant *i, const fmpq *y);

/**
 * The derivative of order k of the pullback of a plane form along the trajectory of P = M(u) y, at
 * u, as a form in (y, 1) and times a positive number that depends on the instant and k alone.
 * @param[out] out d + 1 initialised integers
 * @param k 1 to INSTANT_DERIVATIVES
 */
void instant_pullback(fmpz *out, const instant *i, const fmpz *form, int k);

/** The gradient by P of the pullback of a plane form, times a positive number: an outward normal of
 * the moved facet if the form is positive outside. */
void instant_normal(fmpq *out, const instant *i, const fmpz *form);

/* Facets in contact at all of their points at one time, which a search at sampled times would miss.
 */

/** Look for such facets among the planes of the solid: all planes, or if there are too many,
 * planes evenly spread among them. Facets whose time is irrational are not found.
 */
graze_status specials_find(specials *out, graze_context *context, const graze_scene *scene);
void specials_clear(specials *list);

/** The derivative by u of the pullback of a plane form along the trajectory of P = M(u) y, at u
 * itself: zero where the normal velocity of y is zero. */
void special_velocity(fmpz_poly_t out, const graze_scene *scene, size_t piece, const fmpz *form,
                      const fmpq *y);

/** Find the rational roots of a polynomial in (0, 1), at most SPECIAL_ROOTS; returns their number.
 */
enum { SPECIAL_ROOTS = 40 };
int special_roots(fmpq *out, const fmpz_poly_t p);

/** A time for a contact of a stratum; NULL if there is none. */
const instant *stratum_instant(const struct graze_generator *g, graze_stratum stratum,
                               random_stream *r);

/** The order of a contact by its pullback, at the time u: the multiplicity of the root, or that of
 * a slide. f is differentiated. */
int order_of_root(fmpz_poly_t f, const fmpq_t u);

/** Whether a contact of this order belongs to the stratum. */
int stratum_takes_order(graze_stratum stratum, int order);

/** 0 if the generator keeps to points whose coordinates are doubles, and this point is none. */
int sample_is_kept(const sample *s, const struct graze_generator *g);

/* Query points of one stratum. */

/** The stream that the search for levels draws from: no row of a table has it. */
#define LEVEL_STREAM (UINT64_C(5) << 61)

/** Try once for a contact of a stratum.
 * @param[out] made 0 if this try made none
 * @param[out] normal d rationals, an outward normal of the moved facet; may be NULL
 * @return of a polyhedron GRAZE_OK; else GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM */
graze_status stratum_contact(int *made, sample *out, fmpq *normal, graze_context *context,
                             const struct graze_generator *g, graze_stratum stratum,
                             random_stream *r);

/** Try once for a point of a stratum but `level` and `rounded`; as stratum_contact. */
graze_status stratum_try(int *made, sample *out, graze_context *context,
                         const struct graze_generator *g, graze_stratum stratum, random_stream *r);

/* Query points whose signed distance lies in a stated decade, on a stated side. */

/**
 * Find the decades of |s| that the scene has points of, on each side: those of `in` points from the
 * largest down to 1e-9 of the diagonal, and the same ones of `out` points. Those among them that no
 * try finds are the missing ones.
 * @return GRAZE_ELIMIT the scene is beyond what distances are computed for; GRAZE_ECANCELED,
 * GRAZE_ESYSTEM
 */
graze_status levels_find(struct graze_generator *g, graze_context *context);

/** Try once for a point of one of the generator's levels: the point of a contact, displaced along
 * the normal, whose enclosure of s lies in the decade. *made is 0 if this try made none. */
graze_status level_try(int *made, sample *out, graze_context *context,
                       const struct graze_generator *g, random_stream *r);

/* Query points within an ulp of a contact. */

/** Try once for a point whose coordinates are doubles next to those of a contact's point: for a
 * coordinate that is no double one of its two neighbours, for a double itself or the double before
 * or behind it. Among such points one on a side that is drawn, inside or outside, is taken, if
 * there is one; the sample has its exact answer.
 * @param[out] made 0 if this try made none
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL
 */
graze_status rounded_try(int *made, sample *out, graze_context *context,
                         const struct graze_generator *g, random_stream *r);

/* Query points that touch a polyhedron or a polygon. */

/** As stratum_contact, which is 0 if this try made none. */
int straight_contact(sample *out, fmpq *normal, const struct graze_generator *g,
                     graze_stratum stratum, random_stream *r);

/* Normal velocities of a simplex's corners at an instant, in doubles. */

/**
 * Whether the first derivative of the pullback of a simplex's plane certainly has one sign at all
 * its corners, and so nowhere on the simplex the value 0 (proofs/doubles.md C64).
 * @return 0 if it has not, or that is not certain
 */
int velocity_has_one_sign(const instant *i, const graze_solid *solid, size_t simplex);

#endif
