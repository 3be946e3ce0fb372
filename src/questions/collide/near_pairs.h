/* Pairs of simplices that may meet during an interval, by two trees of boxes and by directions
 * along which they are apart, in doubles with proved bounds (proofs/collision.md C108).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_NEAR_PAIRS_H
#define GRAZE_COLLIDE_NEAR_PAIRS_H

#include "questions/collide/control_maps.h"
#include "questions/collide/solid_pair.h"

/** Nodes of the two solids' trees, or leaves. */
typedef struct node_pair {
    uint32_t moving, fixed;
} node_pair;

typedef struct node_list {
    size_t count, capacity;
    node_pair *item;
} node_list;

/**
 * Cut pairs of nodes down to leaves, and leave out those that are certainly apart.
 * @param maps    the motion during the interval
 * @param in      pairs of nodes
 * @param[out] near   pairs of leaves are appended that are about as large as their way, or all if
 *                    `at_once`
 * @param[out] coarse pairs of nodes are appended whose way is longer than both: a shorter interval
 *                    tells more; none if `at_once`
 * @return GRAZE_ESYSTEM, GRAZE_ECANCELED
 */
graze_status near_pairs_refine(node_list *near, node_list *coarse, graze_context *context,
                               const solid_pair *pair, const control_maps *maps,
                               const node_list *in, int at_once);

/** The simplices of pairs of leaves. */
graze_status near_pairs_take(near_list *out, graze_context *context, const solid_pair *pair,
                             const node_list *leaves);

graze_status node_list_add(node_list *list, graze_context *context, node_pair item);

#endif
