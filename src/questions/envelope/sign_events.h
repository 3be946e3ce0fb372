/* Events of one cell: signs of velocities, their derivatives and axes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_ENVELOPE_SIGN_EVENTS_H
#define GRAZE_QUESTIONS_ENVELOPE_SIGN_EVENTS_H

#include "base/context/array.h"
#include "questions/envelope/envelope.h"

/* The derivatives of the trajectories through the points of the body, by polynomials of time.
 *
 * The point M(u) y has the trajectory c = M^-1 M(u) y in the solid's frame, so c(u) = y. On a piece
 * the derivatives of c at u are c^(k) = Phi_k (y, 1) / Delta^k for k = 1, 2, 3. Phi_k is a matrix
 * of polynomials, d rows and d + 1 columns; Delta > 0 on [0, 1] (proofs/events.md C77). */

/** @param[out] out uninitialised; derivatives_clear in any case */
graze_status piece_field_make(derivatives *out, graze_context *context, const motion_piece *piece,
                              const cell_complex *cells);
void derivatives_clear(derivatives *f);

/** Phi_k applied to a vertex's homogeneous integers, 1 <= k <= 3: d polynomials. */
const fmpz_poly_struct *derivatives_at(const derivatives *f, int k, size_t vertex);

/** g of a facet at a vertex, times a positive function: -n Phi_1 for the outward normal n. */
void derivatives_velocity(fmpz_poly_t out, const derivatives *f, size_t facet, size_t vertex);
/** n Phi_k at a vertex: times positive functions -g for k = 1, theta for k = 2, the third
 * derivative of the pullback for k = 3; the last two only where the lower derivatives are 0. */
void derivatives_along(fmpz_poly_t out, const derivatives *f, int k, size_t facet, size_t vertex);

/* Signs of several polynomials all along [0, 1]: at their roots, at the ends, and between. */

/** Numbers 0 = point[0] < ... < point[count - 1] = 1, and for k >= 1 a rational sample[k] between
 * points k - 1 and k. Each root in [0, 1] of a given polynomial that is not the zero polynomial is
 * a point. */
typedef struct axis {
    algebraic_list roots;
    algebraic **point;
    size_t count;
    fmpq *sample; /* count, the first unused */
} axis;

/** @param[out] out uninitialised; axis_clear in any case */
graze_status axis_make(axis *out, graze_context *context, const fmpz_poly_struct *p, size_t count);
void axis_clear(axis *x);

/** Sign of a polynomial between points k - 1 and k, 1 <= k < count. */
int axis_sign_before(const axis *x, const fmpz_poly_struct *p, size_t k);

/** The sign of a polynomial on [0, 1] if a cheap test shows that it has no root there; else 0. */
int axis_one_sign(const fmpz_poly_struct *p);

/* The signs of a few polynomials along a piece of the motion, and the events they make. */

/** The points of the axis are 0, 1 and the roots of the first `rooted` polynomials. The signs of
 * polynomial p are at[k * count + p] at point k of the axis, and before[k * count + p] between
 * points k - 1 and k.
 */
typedef struct signs {
    size_t count, rooted;
    axis x;
    fmpz_poly_struct *p;
    signed char *at, *before;
} signs;

/** Make `count` zero polynomials; the caller sets them before signs_find. */
void signs_init(signs *s, size_t count, size_t rooted);
void signs_clear(signs *s);
graze_status signs_find(signs *s, graze_context *context);

/** The signs of all polynomials at point k, and between points k - 1 and k. */
const signed char *signs_at(const signs *s, size_t k);
const signed char *signs_before(const signs *s, size_t k);

/* Events of an envelope, collected piece by piece and put in order of time. */

/** The sign of a quantity where it is not defined. */
enum { SIGN_NONE = GRAZE_SIGN_ABSENT };

void events_init(event_list *list, const graze_motion *motion);
void events_clear(event_list *list);

/** Add a copy of an event, at parameter u of a piece. */
graze_status events_add(event_list *list, graze_context *context, const found_event *what,
                        size_t piece, const algebraic *u);

/** The signs of one quantity just before the end of the previous piece, and at that end. */
typedef struct watch {
    int before, at;
} watch;

/** The sign of a quantity from the signs of the polynomials at one place, or SIGN_NONE. */
typedef int watched_sign(const signed char *sign);

/** Add the events of a quantity on the next piece: the times at which its sign differs from its
 * sign just before or just after (proofs/events.md C79).
 * @param past ignored on the first piece; the caller passes it on to the call for the next piece
 */
graze_status events_watch(event_list *list, graze_context *context, const found_event *what,
                          watch *past, size_t piece, const signs *s, watched_sign *sign);

/** Sort the events by time and list their times. */
graze_status events_finish(event_list *list, graze_context *context);

/* Moments at which a cell's contacts may change (proofs/events.md C84). */

/** @param[out] out uninitialised; cell_events_clear in any case */
graze_status cell_events_make(cell_event_list *out, graze_context *context, const graze_envelope *e,
                              const moment_list *moments);
void cell_events_clear(cell_event_list *list);

/** Set a list to the hard moments. */
graze_status cuts_start(numbers *cuts, graze_context *context, const moment_list *moments);
graze_status cuts_add(numbers *cuts, graze_context *context, size_t moment);

/** Add the moments at which a facet, an edge, a vertex has events; for an edge also the moments at
 * which the slice of one of its facets reaches an end of the edge. */
graze_status cuts_add_of_facet(numbers *cuts, graze_context *context, const cell_event_list *list,
                               const cell_complex *c, size_t facet);
graze_status cuts_add_of_edge(numbers *cuts, graze_context *context, const cell_event_list *list,
                              const cell_complex *c, size_t edge);
graze_status cuts_add_of_vertex(numbers *cuts, graze_context *context, const cell_event_list *list,
                                const cell_complex *c, size_t vertex);

/* Contact on one side of a break of the motion, and the solid's interior on the other. */

/** Note the findings at the break at the beginning of a piece (proofs/events.md C83). */
graze_status breaks_judge(graze_envelope *e, graze_context *context, size_t piece);

/* Where the slice of a facet goes from a vertex. */

/** Whether the slice, or the whole facet if g = 0 on it, goes on from a vertex with g = 0 into the
 * relative interior of the facet or of a flat edge of it, at point k of a piece's axis or, in
 * enters_before, between points k - 1 and k. */
graze_status enters_at(int *out, const graze_envelope *e, graze_context *context, size_t facet,
                       size_t vertex, size_t piece, const axis *x, size_t k);
int enters_before(const graze_envelope *e, size_t facet, size_t vertex, size_t piece, const axis *x,
                  size_t k);

/* Velocities of a vertex that lead into the solid. */

/** Does w, the velocity of the trajectory through a vertex, or -w point into the solid's interior?
 * @param sign signs of g of the vertex's facets at u, in the order of vertex_facets; not all 0
 */
graze_status inward_decide(int *out, const graze_envelope *e, graze_context *context, size_t vertex,
                           size_t piece, algebraic *u, const signed char *sign);

/* Vertices where the solid is neither flat nor convex: `saddle` events, and slices and runs that
 * reach them. */

/** Gather `saddle` at a vertex, for all pairs of edges at the vertex that do not span the plane of
 * one of its facets (E^3). */
graze_status saddle_gather(graze_envelope *e, graze_context *context, size_t vertex);
/** Note a finding where a run reaches the vertex, and where a slice or a run reaches it and the
 * velocity or its opposite leads into the solid. */
graze_status saddle_judge(graze_envelope *e, graze_context *context, size_t vertex);

/* Contacts of order 4 or more within a facet: [AMS] singular trim points. */

/** Gather `singular` events of a facet (E^3). */
graze_status singular_gather(graze_envelope *e, graze_context *context, size_t facet);

/* Facets with g = 0 at all of their points. */

/** Set `still` of a facet. At single times at which g vanishes on all of the facet, note a finding
 * if theta is negative at a corner, or if another facet of a reflex edge has g not 0 at an end of
 * that edge. */
graze_status gather_whole(graze_envelope *e, graze_context *context, size_t facet);

#endif
