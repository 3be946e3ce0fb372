/* Lists of places and of joints. SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "questions/envelope/patch_ends.h"

static graze_status add_patch_place(place_list *list, graze_context *context, int is_edge,
                                    size_t cell, size_t facet, size_t patch) {
    TRY(LIST_GROW(context, list, "the ends of patches"));
    list->item[list->count++] = (patch_place){is_edge, cell, facet, patch};
    return GRAZE_OK;
}

static graze_status add_end(place_list *list, graze_context *context, const part_end *end,
                            size_t patch) {
    return end->vertex != SIZE_MAX
               ? add_patch_place(list, context, 0, end->vertex, SIZE_MAX, patch)
               : add_patch_place(list, context, 1, end->edge, end->facet, patch);
}

/* Add the places of a whole facet: all its edges; in E^2 the vertices of its edges. */
static graze_status add_border_places(place_list *list, graze_context *context,
                                      const cell_complex *c, size_t facet, size_t patch) {
    for (size_t j = c->facet_edges.start[facet]; j < c->facet_edges.start[facet + 1]; j++) {
        size_t edge = c->facet_edges.item[j];
        if (c->dimension == 3) {
            TRY(add_patch_place(list, context, 1, edge, SIZE_MAX, patch));
            continue;
        }
        TRY(add_patch_place(list, context, 0, c->edge[edge].u, SIZE_MAX, patch));
        TRY(add_patch_place(list, context, 0, c->edge[edge].v, SIZE_MAX, patch));
    }
    return GRAZE_OK;
}

/* Add the places of a patch. A run between both ends of its edge has, besides its ends, all of the
 * edge as a place. */
static graze_status add_patch_places(place_list *list, graze_context *context,
                                     const cell_complex *c, const patch *item, size_t patch) {
    const part_end *a = &item->end[0], *b = &item->end[1];
    if (item->facts.kind == GRAZE_CURVE_WHOLE)
        return add_border_places(list, context, c, item->number, patch);
    TRY(add_end(list, context, a, patch));
    TRY(add_end(list, context, b, patch));
    if (item->facts.kind == GRAZE_CURVE_RUN && a->vertex != SIZE_MAX && b->vertex != SIZE_MAX)
        TRY(add_patch_place(list, context, 1, item->number, SIZE_MAX, patch));
    return GRAZE_OK;
}

static int compare_patch_places(const void *left, const void *right) {
    const patch_place *a = left, *b = right;
    int order = a->is_edge - b->is_edge;
    order = order ? order : array_compare_numbers(&a->cell, &b->cell);
    order = order ? order : array_compare_numbers(&a->patch, &b->patch);
    return order ? order : array_compare_numbers(&a->facet, &b->facet);
}

graze_status places_make(place_list *out, graze_context *context, const graze_patches *p) {
    for (size_t k = 0; k < p->count; k++)
        TRY(add_patch_places(out, context, &p->envelope->cells, &p->item[k], k));
    out->count = array_sort_once(out->item, out->count, sizeof *out->item, compare_patch_places);
    return GRAZE_OK;
}

void place_list_clear(place_list *list) {
    free(list->item);
}

size_t places_first(const place_list *list, int is_edge, size_t cell) {
    const patch_place key = {is_edge, cell, 0, 0};
    return array_first(&key, list->item, list->count, sizeof key, compare_patch_places);
}

graze_status members_add(numbers *set, graze_context *context, size_t patch) {
    return numbers_add(set, context, patch, "the patches of a joint");
}

graze_status joint_add(graze_patches *p, graze_context *context, const graze_cell *cell,
                       graze_chain_form form, size_t from, size_t to, const numbers *set) {
    TRY(array_grow(context, &p->joint, &p->joint_capacity, p->joint_count + 1, sizeof *p->joint,
                   "the joints of patches"));
    TRY(array_grow(context, &p->member, &p->member_capacity, p->member_count + set->count,
                   sizeof *p->member, "the joints of patches"));
    p->joint[p->joint_count++] = (patch_joint){*cell, form, from, to, p->member_count, set->count};
    for (size_t k = 0; k < set->count; k++)
        p->member[p->member_count++] = set->item[k];
    return GRAZE_OK;
}
