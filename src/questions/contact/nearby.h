/* Parts of a site: its flow, planes, nearest points, role and times.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_CONTACT_NEARBY_H
#define GRAZE_QUESTIONS_CONTACT_NEARBY_H

#include <flint/fmpq.h>
#include "questions/contact/contact.h"

/* The point of a union of convex sets that is nearest to a given point, found set by set. */

/** The point nearest to `from` (borrowed) so far; of equally near points the lexicographically
 * first. */
typedef struct nearby {
    int dimension, found;
    const fmpq *from;
    fmpq *point;
    fmpq_t square; /* of the distance */
} nearby;

void nearby_init(nearby *n, const fmpq *from, int dimension);
void nearby_clear(nearby *n);

/** Take a point if it is nearer, or as near and lexicographically before. */
void nearby_try(nearby *n, const fmpq *point);

/** Take the point of the segment from a to b that is nearest to `from`; a may be b. */
void nearby_try_segment(nearby *n, const fmpq *a, const fmpq *b);

/* The velocity of trajectories on both sides of a time. */

/** Is one piece on both sides? */
int sides_within_piece(const site_side side[2]);

/** Make the flows of sides that sides_find has set; the caller clears them. */
void sides_add_flows(site_side side[2], const graze_motion *motion);

/** The flow on side k: 0 before the time, 1 after it. */
const flow *sides_flow(const site_side side[2], int k);

/** g = -n w(y) on side k. */
void sides_speed(fmpq_t out, const site_side side[2], int k, const fmpz *normal, const fmpq *y);

/* Where an edge of a solid in E^3 is in contact at a time. */

/**
 * Try the nearest point of the contact set of the edge between two corners (proofs/snap.md C75).
 * @return GRAZE_EINPUT more than two facets, or none, meet along the edge
 */
graze_status edge_run_try(nearby *n, graze_context *context, const graze_solid *solid,
                          const fmpq *u, const fmpq *v, const site_side side[2]);

/* The points of a facet in contact at a time: g <= 0 on the side after the time and g >= 0 on the
 * side before it; within a piece of the motion g = 0. */

/** Try the nearest point of the contact set of a simplex of the boundary (proofs/snap.md C75). */
void facet_slice_try(nearby *n, const graze_solid *solid, size_t simplex, const site_side side[2]);

/* The first-order role of a site. */

/**
 * Find the role of a site whose place, sides, germs and points are set (proofs/envelope.md C60).
 * @return GRAZE_ELIMIT too many planes border the covered directions; else as cone_state
 */
graze_status role_decide(graze_role *out, graze_context *context, const graze_site *site);

/* The contact set of a boundary cell at a time, and the point of it that is nearest to another. */

/** Find the point of the contact set of a cell at t that is nearest to n->from (proofs/snap.md
 * C75); for a vertex it is the vertex's position, whatever its role.
 * @param[in,out] n without a point yet; no point is found if the set is empty
 * @return GRAZE_EINPUT t is not a time of the motion, the solid has no such cell, or more than two
 * facets meet along an edge; GRAZE_ELIMIT; GRAZE_ESYSTEM
 */
graze_status snap_find(nearby *n, graze_context *context, const graze_scene *scene, const fmpq_t t,
                       const graze_cell *cell);

/* The position of a site's time among the contacts in the trace of its point. */

/**
 * Find, from the trace of a site, `left`, `right` and `trim` of its facts, `near`, `near_in` and,
 * if one of these two times is t, `itself` (proofs/envelope.md C63).
 * @return GRAZE_EINTERNAL no contact of the trace holds t
 */
graze_status nearest_find(graze_site *site, graze_context *context);

/** Find `left`, `right` and `trim` of the site's facts, without the times. */
graze_status nearest_trim(graze_site *site, graze_context *context);

/* The sides of a rational time of a motion. */

/**
 * Find the pieces and parameters of the sides of t; their flows are not set.
 * @param[out] side initialised; before t first
 * @return GRAZE_EINPUT the motion has no such time
 */
graze_status sides_find(site_side side[2], graze_context *context, const graze_motion *motion,
                        const fmpq_t t);

#endif
