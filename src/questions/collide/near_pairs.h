/* Pairs of cells that come near, and the walk along the motion.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_COLLIDE_NEAR_PAIRS_H
#define GRAZE_QUESTIONS_COLLIDE_NEAR_PAIRS_H

#include "questions/collide/features.h"

/* Pairs of boundary cells, one of each solid, that meet at a time. */

/** Find all pairs of relatively open cells with a common point at the placing's time
 * (proofs/collision.md C109). At that time no edge of one solid may pass through a simplex of the
 * other.
 * @param near all pairs of simplices that meet then, and perhaps others */
void cell_pairs_find(cell_pairs *out, placing *p, const near_list *near);

/* Pairs of simplices that may meet, or come as near as the clearance, during an interval: two trees
 * of boxes and separating directions exclude all others, in doubles with proved bounds
 * (proofs/collision.md C108). */

/** Two nodes, one of each solid's tree. */
typedef struct node_pair {
    uint32_t moving, fixed;
} node_pair;

typedef struct node_list {
    size_t count, capacity;
    node_pair *item;
    int within; /* 1: points of some pair are always nearer than the clearance; the list is not
                   complete then */
    int soon;   /* 1: points of some pair are that in a few halves of the interval */
} node_list;

/** Refine pairs of nodes down to leaves; drop pairs that are certainly apart.
 * @param maps    the motion during the interval
 * @param in the pairs of nodes to refine
 * @param[out] near the pairs of leaves that are left are appended, or `within` is set; without
 * `at_once` only those that do not move much further than they are large
 * @param[out] coarse pairs of nodes that move further than they are large are appended, for a
 * shorter interval; with `at_once` there are none
 * @return GRAZE_ESYSTEM, GRAZE_ECANCELED */
graze_status near_pairs_refine(node_list *near, node_list *coarse, graze_context *context,
                               const solid_pair *pair, const control_maps *maps,
                               const node_list *in, int at_once);

/** Replace a list by the pairs of simplices of pairs of leaves. */
graze_status near_pairs_take(near_list *out, graze_context *context, const solid_pair *pair,
                             const node_list *leaves);

/** Find the pairs that may come as near as the clearance during an interval of a placing's piece,
 * or at its rational time, among those of `of`; NULL: among all.
 * @param[out] within node_list.within; NULL: pairs that are nearer are found too */
graze_status near_pairs_find(near_list *out, int *within, const placing *p,
                             const dyadic_interval *interval, const node_list *of);

/** Append the pairs of faces with feet that are within the clearance at a placing's time. */
graze_status features_near(feature_list *out, placing *p);

void node_list_clear(node_list *list);
graze_status node_list_add(node_list *list, graze_context *context, node_pair item);

/* Builds the pair word, state by state, from the times at which it can change (proofs/collision.md
 * C112). */

void pair_walk_clear(pair_walk *walk);

/** Begin a walk; if only the first contact is asked for, find the state at t0. */
graze_status pair_walk_begin(pair_walk *walk);

/** Walk to a time of a piece at which the boundaries meet. No time of incidences_find between the
 * last time and this one may be left out.
 * @param near pairs of leaves, with all that meet then
 * @param whole a placing on the whole piece */
graze_status pair_walk_to(pair_walk *walk, placing *whole, size_t piece, const algebraic *time,
                          const node_list *near);

/** Find the state just after the last time, if a contact is open there and the state is not known.
 * @param u a time of a piece; no contact is between the last time and u */
graze_status pair_walk_on(pair_walk *walk, size_t piece, const fmpq_t u);

/** Walk to a time of a piece at which, and for a while before which, the interiors meet. */
graze_status pair_walk_pass(pair_walk *walk, size_t piece, const fmpq_t u);

/** Walk to the end of the motion. */
graze_status pair_walk_end(pair_walk *walk);

/* Directions that separate corners, or the simplices below two nodes, during an interval of time,
 * in doubles with proved bounds (proofs/collision.md C108). */

/** A bound of the sum of the errors of a moved and of a standing corner in doubles; infinite if
 * none is known. */
double error_of_places(const solid_pair *pair, const control_maps *maps);

/** Certain distances of the convex hulls of some corners of both solids during an interval. */
typedef enum nearness {
    NEAR_UNKNOWN = 0,
    NEAR_NEVER,  /* they are disjoint, and further apart than the clearance, at all times */
    NEAR_ALWAYS, /* two of their points are nearer than the clearance at all times */
    NEAR_SOON    /* two of them are that in the middle, and not far from it at other times */
} nearness;

/** Compare corners of the moving and of the fixed solid during the interval of the maps.
 * @param error from error_of_places */
nearness corners_nearness(const solid_pair *pair, const control_maps *maps, corner_run moving,
                          corner_run fixed, double error);

/** Are all simplices below two nodes certainly apart like this, by the nodes' slabs? */
int slabs_apart(const solid_pair *pair, const control_maps *maps, uint32_t moving, uint32_t fixed,
                double error);

/* A search for the times at which two boundaries meet, in order of time. */

/** Walk through the whole motion or, if only the first contact is asked for, up to that contact. */
graze_status pair_search(pair_walk *walk);

#endif
