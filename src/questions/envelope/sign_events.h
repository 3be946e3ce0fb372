/* Events of one cell: signs of velocities, their derivatives and axes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_ENVELOPE_SIGN_EVENTS_H
#define GRAZE_QUESTIONS_ENVELOPE_SIGN_EVENTS_H

#include "base/context/array.h"
#include "base/number/algebraic.h"
#include "questions/envelope/envelope.h"

/* The derivatives of the trajectories through the points of the body, by polynomials of time.
 *
 * The point M(u) y has the trajectory c = M^-1 M(u) y in the solid's frame, so c(u) = y. On a piece
 * its derivatives at u are c^(k) = Phi_k (y, 1) / Delta^k for k = 1, 2, 3. Phi_k is a matrix of
 * polynomials, d rows and d + 1 columns; Delta > 0 on [0, 1] (proofs/events.md C77). */

/** @param[out] out uninitialised; derivatives_clear in any case */
graze_status piece_field_make(derivatives *out, graze_context *context, const motion_piece *piece,
                              const cell_complex *cells);
void derivatives_clear(derivatives *f);

/** The components of Phi_k at a vertex, 1 <= k <= 3: d polynomials. */
const fmpz_poly_struct *derivatives_at(const derivatives *f, int k, size_t vertex);

/** The velocity g of a facet at a vertex, -n Phi_1 for its outward normal: g times a positive
 * function. */
void derivatives_velocity(fmpz_poly_t out, const derivatives *f, size_t facet, size_t vertex);
/** n Phi_k at a vertex, times a positive function: theta for k = 2, the third derivative of the
 * pullback for k = 3, each only where the lower derivatives are 0. */
void derivatives_along(fmpz_poly_t out, const derivatives *f, int k, size_t facet, size_t vertex);

/* Signs of several polynomials all along [0, 1]: at their roots, at the ends, and between. */

/** Numbers 0 = point[0] < ... < point[count - 1] = 1, and between two of them a rational sample:
 * sample[k] before point k, k >= 1. Every root in [0, 1] of a polynomial that is not zero is a
 * point. */
typedef struct axis {
    algebraic_list roots;
    algebraic **point;
    size_t count;
    fmpq *sample; /* count, the first unused */
} axis;

/** @param[out] out uninitialised; axis_clear in any case */
graze_status axis_make(axis *out, graze_context *context, const fmpz_poly_struct *p, size_t count);
void axis_clear(axis *x);

/** Sign of a polynomial at point k. */
graze_status axis_sign(int *out, graze_context *context, axis *x, const fmpz_poly_struct *p,
                       size_t k);
/** Its sign between points k - 1 and k, 1 <= k < count. */
int axis_sign_before(const axis *x, const fmpz_poly_struct *p, size_t k);

/** The sign of a polynomial without roots in [0, 1] there, if a cheap test shows it, else 0. */
int axis_one_sign(const fmpz_poly_struct *p);

/* The signs of a few polynomials along a piece of the motion, and the events they make. */

/** The first `rooted` polynomials have their roots among the points. The signs of polynomial p are
 * at[k * count + p] at point k of the axis, and before[k * count + p] between points k - 1 and k.
 */
typedef struct signs {
    size_t count, rooted;
    axis x;
    fmpz_poly_struct *p;
    signed char *at, *before;
} signs;

/** Begin with `count` zero polynomials, which the caller sets before signs_find. */
void signs_init(signs *s, size_t count, size_t rooted);
void signs_clear(signs *s);
graze_status signs_find(signs *s, graze_context *context);

/** The signs of all polynomials at point k and before it. */
const signed char *signs_at(const signs *s, size_t k);
const signed char *signs_before(const signs *s, size_t k);

/* Events of an envelope, collected piece by piece and put in order of time. */

/** A sign that a quantity does not have where it is not defined. */
enum { SIGN_NONE = GRAZE_SIGN_ABSENT };

void events_init(event_list *list, const graze_motion *motion);
void events_clear(event_list *list);

/** One more event, copied but for its time. */
graze_status events_add(event_list *list, graze_context *context, const found_event *what,
                        size_t piece, const algebraic *u);

/** The signs of one quantity just before the end of the last piece, and at that end. */
typedef struct watch {
    int before, at;
} watch;

/** The sign of a quantity from the signs of the polynomials at one place, or SIGN_NONE. */
typedef int watched_sign(const signed char *sign);

/** Add the events of a quantity on the next piece: times at which its sign differs from its sign
 * before or after them (proofs/events.md C79).
 * @param past on the first piece anything; kept for the next one
 */
graze_status events_watch(event_list *list, graze_context *context, const found_event *what,
                          watch *past, size_t piece, const signs *s, watched_sign *sign);

/** Put the events in order, with their times. */
graze_status events_finish(event_list *list, graze_context *context);

/* Moments at which a cell's contacts may change (proofs/events.md C84). */

/** @param[out] out uninitialised; cell_events_clear in any case */
graze_status cell_events_make(cell_event_list *out, graze_context *context, const graze_envelope *e,
                              const moment_list *moments);
void cell_events_clear(cell_event_list *list);

/** Empty a list and put the hard moments there. */
graze_status cuts_start(numbers *cuts, graze_context *context, const moment_list *moments);
graze_status cuts_add(numbers *cuts, graze_context *context, size_t moment);

/** Add the moments at which a facet, an edge, a vertex has events; for an edge also those at which
 * one of its facets has an event at one of its ends. */
graze_status cuts_add_of_facet(numbers *cuts, graze_context *context, const cell_event_list *list,
                               const cell_complex *c, size_t facet);
graze_status cuts_add_of_edge(numbers *cuts, graze_context *context, const cell_event_list *list,
                              const cell_complex *c, size_t edge);
graze_status cuts_add_of_vertex(numbers *cuts, graze_context *context, const cell_event_list *list,
                                const cell_complex *c, size_t vertex);

/* Contact on one side of a break of the motion, and the solid's interior on the other. */

/** Look at the break at the beginning of a piece (proofs/events.md C83). */
graze_status breaks_judge(graze_envelope *e, graze_context *context, size_t piece);

/* Where the slice of a facet goes from a vertex. */

/** Whether the slice, or the whole facet if g = 0 on it, goes on from a vertex with g = 0 into the
 * relative interior of the facet or of a flat edge of it, at point k of a piece's axis or before
 * it. */
graze_status enters_at(int *out, const graze_envelope *e, graze_context *context, size_t facet,
                       size_t vertex, size_t piece, const axis *x, size_t k);
int enters_before(const graze_envelope *e, size_t facet, size_t vertex, size_t piece, const axis *x,
                  size_t k);

/* Velocities of a vertex that lead into the solid. */

/** Does w, the velocity of the trajectory through a vertex, or -w point into the solid's interior?
 * @param sign of g of the vertex's facets at u, in their order; not all 0
 */
graze_status inward_decide(int *out, const graze_envelope *e, graze_context *context, size_t vertex,
                           size_t piece, algebraic *u, const signed char *sign);

/* Vertices that are not convex: events of saddles, and what reaches them. */

/** `saddle` at a vertex, for all pairs of edges there that span no facet's plane (E^3). */
graze_status saddle_gather(graze_envelope *e, graze_context *context, size_t vertex);
/** Does a slice or a run reach the vertex, and does the velocity or its opposite lead into the
 * solid there? */
graze_status saddle_judge(graze_envelope *e, graze_context *context, size_t vertex);

/* Contacts of order 4 or more within a facet: [AMS] singular trim points. */

/** `singular` of a facet (E^3). */
graze_status singular_gather(graze_envelope *e, graze_context *context, size_t facet);

/* Whether a facet has a contact of order 4 or more, [AMS]'s singular trim points, at a time. */

/** g, theta and the third derivative at the corners of the facet's first triangle; the products of
 * two of these rows, three each; and the determinant. */
enum {
    SINGULAR_ROWS = 9,
    SINGULAR_MINORS = 9,
    SINGULAR_DETERMINANT = SINGULAR_ROWS + SINGULAR_MINORS,
    SINGULAR_SIGNS
};

/** A facet on one piece of the motion. */
typedef struct singular_view {
    const graze_envelope *e;
    graze_context *context;
    size_t facet, piece;
    fmpz_poly_struct p[SINGULAR_SIGNS];
} singular_view;

/** @param[out] out uninitialised; singular_view_clear after it */
void singular_view_init(singular_view *out, const graze_envelope *e, graze_context *context,
                        size_t facet, size_t piece);
void singular_view_clear(singular_view *v);

/** Does a cheap test show that g has one strict sign at all corners of the facet, at all times of
 * the piece? Then the facet has no such point. 0 says nothing. */
int singular_is_never(const singular_view *v);

/** Is the determinant 0 at all times of the piece? If not, such points occur at its roots only. */
int singular_is_lasting(const singular_view *v);

/** Is there such a point in the facet's relative interior at u? */
graze_status singular_exists(int *out, const singular_view *v, algebraic *u);

/** Find the times at which the answer of singular_exists may change (proofs/events.md C80): between
 * two of them it is constant. @param[out] out uninitialised; axis_clear in any case */
graze_status singular_axis(axis *out, const singular_view *v);

/* Facets whose g vanishes all over. */

/** Times at which g vanishes all over a facet: whether theta is negative there, or an edge or
 * corner of it reflex. */
graze_status gather_whole(graze_envelope *e, graze_context *context, size_t facet);

/* A point of a facet that lies in no lower cell. */

/** The middle of the facet's first simplex, or, if a vertex or an edge of another facet lies
 * there, a point beside it. @param[out] out d rationals */
graze_status within_facet(fmpq *out, graze_context *context, const cell_complex *cells,
                          size_t facet);

#endif
