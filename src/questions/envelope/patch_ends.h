/* Where patches begin and end, and how they are joined.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_ENVELOPE_PATCH_ENDS_H
#define GRAZE_QUESTIONS_ENVELOPE_PATCH_ENDS_H

#include "questions/envelope/sign_events.h"

/* Moments, in order: the ends and breaks of the motion and the times of events. */

/** @param[out] out uninitialised; moments_clear in any case */
graze_status moments_make(moment_list *out, graze_context *context, const graze_envelope *e);
void moments_clear(moment_list *list);

/** A rational time between two moments, from < to, at which the motion is smooth. */
graze_status moments_between(fmpq_t out, graze_context *context, const moment_list *list,
                             size_t from, size_t to);

/* The cells of a boundary. */

/** @param[out] out uninitialised; complex_clear in any case */
graze_status complex_make(cell_complex *out, graze_context *context, const graze_solid *solid);
void complex_clear(cell_complex *c);

/**
 * Find the curve of contact at a time of the motion that is neither an end nor a break. Trim,
 * orientation and chain of its parts are not set.
 * @param[out] out uninitialised; contact_curve_clear after GRAZE_OK
 * @return GRAZE_EINPUT the time is an end or a break of the motion or outside it
 */
graze_status contact_curve_find(graze_curve *out, graze_context *context, const graze_envelope *e,
                                const fmpq_t t);

/* Conditions for an envelope to decompose (proofs/events.md C81 to C83). */

static const graze_cell NO_CELL = {0, 0, 0};

/** Would a finding with this reason replace the one that decides so far? */
int judge_wants(const graze_envelope *e, graze_decomposable_reason reason);

/** Note a finding at parameter u of a piece; it is kept only if judge_wants its reason.
 * @param facet, cell borrowed */
graze_status judge_find(graze_envelope *e, graze_context *context, graze_decomposable_reason reason,
                        const graze_cell *facet, const graze_cell *cell, size_t piece,
                        const algebraic *u);
/** Note a finding between points k - 1 and k of an axis. */
graze_status judge_find_before(graze_envelope *e, graze_context *context,
                               graze_decomposable_reason reason, const graze_cell *facet,
                               const graze_cell *cell, size_t piece, const axis *x, size_t k);

/** Is point k of an axis neither an end nor a break of the motion? */
int judge_is_inner(const graze_envelope *e, size_t piece, const axis *x, size_t k);
/** Is point k of an axis a break of the motion? */
int judge_is_break(const graze_envelope *e, size_t piece, const axis *x, size_t k);

/** Does g vanish at all points of a facet at all times of the motion? */
int judge_is_still(const graze_envelope *e, size_t facet);

/* The edges of a boundary by position, cut where parts touch. */

/** Fill `edge` except for names and kinds, and append the crossings of edges to the vertices'
 * positions. Facets, corners and the positions of the solid's vertices must be set before. */
graze_status edges_find(cell_complex *c, graze_context *context);

/* Events and findings of facets, edges and vertices, by the signs of g at vertices. */

/** Gather `reach` at a vertex of a facet, and `cusp` there on pieces all along which g is 0 at the
 * vertex. */
graze_status gather_corner(graze_envelope *e, graze_context *context, size_t facet, size_t vertex);
/** Gather `cusp` and `turn` where the slice of a facet ends on an edge in the facet; in E^2 that
 * end is the slice itself. */
graze_status gather_slice(graze_envelope *e, graze_context *context, size_t facet, size_t edge);
/** Gather `meet` of two facets of an edge; if the edge is reflex, note a finding where a slice of
 * either facet crosses it. */
graze_status gather_meet(graze_envelope *e, graze_context *context, size_t edge, size_t first,
                         size_t second);

/* Patches that meet, where and when. */

/** Find the joints (proofs/events.md C85); all patches must have been found before. */
graze_status joints_find(graze_patches *p, graze_context *context);

/* Where patches end: vertices, and points of edges where g of a facet vanishes. */

/** A place where a patch ends: a vertex; a point within an edge where g of `facet` vanishes; or, if
 * `is_edge` and `facet` is SIZE_MAX, all of an edge. */
typedef struct patch_place {
    int is_edge;
    size_t cell, facet, patch;
} patch_place;

/** Places at vertices before those on edges, both sorted by number of the cell, then by patch; each
 * pair of place and patch once. */
typedef struct place_list {
    size_t count, capacity;
    patch_place *item;
} place_list;

/** @param[out] out zeros; place_list_clear in any case */
graze_status places_make(place_list *out, graze_context *context, const graze_patches *p);
void place_list_clear(place_list *list);
/** The index of the first place of a cell, or the index at which one would be inserted. */
size_t places_first(const place_list *list, int is_edge, size_t cell);

/** Add a patch to a set of patches that meet. */
graze_status members_add(numbers *set, graze_context *context, size_t patch);

/** Add a joint of the patches in a sorted set. */
graze_status joint_add(graze_patches *p, graze_context *context, const graze_cell *cell,
                       graze_chain_form form, size_t from, size_t to, const numbers *set);

/* Patches that meet at a moment. */

/** Add the joints at moments within the motion: patches that begin or end at a moment meet where
 * the limits of their ends coincide, with each other and with patches that go on there
 * (proofs/events.md C85). */
graze_status limits_find(graze_patches *p, graze_context *context, const place_list *places);

/* Velocities of all points of the body at one time. */

/** A time at which the motion is smooth, and c' and c'' of the trajectories there, times a positive
 * number each, as maps of a flow. */
typedef struct snapshot {
    const graze_envelope *e;
    int dimension;
    fmpq_t t;
    fmpz *velocity, *bend;
} snapshot;

/** @param[out] out uninitialised; snapshot_clear in any case
 * @return GRAZE_EINPUT the time is an end or a break of the motion or outside it */
graze_status snapshot_make(snapshot *out, graze_context *context, const graze_envelope *e,
                           const fmpq_t t);
void snapshot_clear(snapshot *s);

/** g of a facet at point y of the body, times a positive number that is the same for all points. */
void snapshot_g(fmpq_t out, const snapshot *s, size_t facet, const fmpq *y);
int snapshot_g_sign(const snapshot *s, size_t facet, const fmpq *y);
/** The sign of theta of a facet at point y. */
int snapshot_theta_sign(const snapshot *s, size_t facet, const fmpq *y);

/* The contact points of facets, edges and vertices at one time, cell by cell. */

/** Add the slice within the facet's relative interior; or the whole facet, if g = 0 on all of it.
 */
graze_status parts_of_facet(graze_curve *c, graze_context *context, const snapshot *s,
                            size_t facet);
/** Add the runs of an edge and the single contacts in its relative interior (E^3). */
graze_status parts_of_edge(graze_curve *c, graze_context *context, const snapshot *s, size_t edge);
/** Add a vertex if it is a contact. */
graze_status parts_add_vertex(graze_curve *c, graze_context *context, const snapshot *s,
                              size_t vertex);
/** Add a vertex if it is a contact and not the end of a part added before. */
graze_status parts_of_vertex(graze_curve *c, graze_context *context, const snapshot *s,
                             size_t vertex);

/** Classify the middle of a part at time t.
 * @param[out] body d rationals: the middle
 * @param[out] world d rationals: the middle in the frame of the query points; or NULL */
graze_status parts_look_at_middle(graze_trim *trim, graze_orientation *orientation, fmpq *body,
                                  fmpq *world, graze_context *context, const graze_envelope *e,
                                  const curve_part *part, const fmpq_t t);

/** Is a point in the facet, its border included? */
int parts_facet_holds(const cell_complex *c, size_t facet, const fmpq *at);
/** Do two triangles of the facet have both vertices as corners? Then the side between a and b lies
 * within the facet. */
int parts_side_is_inner(const cell_complex *c, size_t facet, size_t a, size_t b);

#endif
