/* Pairs of simplices that may meet during an interval: two trees of boxes and separating directions
 * exclude all others, in doubles with proved bounds (proofs/collision.md C108).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_NEAR_PAIRS_H
#define GRAZE_COLLIDE_NEAR_PAIRS_H

#include "questions/collide/control_maps.h"
#include "questions/collide/solid_pair.h"

/** A node of each solid's tree. */
typedef struct node_pair {
    uint32_t moving, fixed;
} node_pair;

typedef struct node_list {
    size_t count, capacity;
    node_pair *item;
} node_list;

/** Refine pairs of nodes down to leaves; drop pairs that are certainly apart.
 * @param maps    the motion during the interval
 * @param in the pairs of nodes to refine
 * @param[out] near the pairs of leaves that are left are appended; without `at_once` only those
 * that do not move much further than they are large
 * @param[out] coarse pairs of nodes that move further than they are large are appended, for a
 * shorter interval; with `at_once` there are none
 * @return GRAZE_ESYSTEM, GRAZE_ECANCELED */
graze_status near_pairs_refine(node_list *near, node_list *coarse, graze_context *context,
                               const solid_pair *pair, const control_maps *maps,
                               const node_list *in, int at_once);

/** Take the simplices of pairs of leaves. */
graze_status near_pairs_take(near_list *out, graze_context *context, const solid_pair *pair,
                             const node_list *leaves);

graze_status node_list_add(node_list *list, graze_context *context, node_pair item);

#endif
