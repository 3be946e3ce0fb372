/* Where patches end: vertices, and points of edges where g of a facet vanishes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_PATCH_ENDS_H
#define GRAZE_ENVELOPE_PATCH_ENDS_H

#include "questions/envelope/patch.h"

/** A vertex, or an edge with a facet in which g vanishes there; SIZE_MAX for all of the edge. */
typedef struct patch_place {
    int is_edge;
    size_t cell, facet, patch;
} patch_place;

/** In the order of vertices, then edges, then patches; each pair of patch and place once. */
typedef struct place_list {
    size_t count, capacity;
    patch_place *item;
} place_list;

/** Numbers of patches that meet. */
typedef struct member_set {
    size_t count, capacity, *item;
} member_set;

/** @param[out] out uninitialised; free its items in any case */
graze_status places_make(place_list *out, graze_context *context, const graze_patches *p);
/** The first entry of a cell's places. */
size_t places_first(const place_list *list, int is_edge, size_t cell);

graze_status members_add(member_set *set, graze_context *context, size_t patch);
/** Put a set in order, each patch once. */
void members_sort(member_set *set);

/** One more joint of the patches in a set. */
graze_status joint_add(graze_patches *p, graze_context *context, const graze_cell *cell,
                       graze_chain_form form, size_t from, size_t to, const member_set *set);

#endif
