/* Lists of places and of joints. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/envelope/envelope.h"

#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "questions/envelope/patch_ends.h"

static graze_status add_patch_place(place_list *list, graze_context *context, int is_edge,
                                    size_t cell, size_t facet, size_t patch) {
    TRY(array_grow(context, &list->item, &list->capacity, list->count + 1, sizeof *list->item,
                   "the ends of patches"));
    list->item[list->count++] = (patch_place){is_edge, cell, facet, patch};
    return GRAZE_OK;
}

static graze_status add_end(place_list *list, graze_context *context, const part_end *end,
                            size_t patch) {
    return end->vertex != SIZE_MAX
               ? add_patch_place(list, context, 0, end->vertex, SIZE_MAX, patch)
               : add_patch_place(list, context, 1, end->edge, end->facet, patch);
}

/* A whole facet ends in all its edges, in E^2 in its vertices. */
static graze_status add_border_places(place_list *list, graze_context *context,
                                      const cell_complex *c, size_t facet, size_t patch) {
    graze_status status = GRAZE_OK;
    for (size_t j = c->facet_edges.start[facet]; j < c->facet_edges.start[facet + 1] && !status;
         j++) {
        size_t edge = c->facet_edges.item[j];
        if (c->dimension == 3) {
            status = add_patch_place(list, context, 1, edge, SIZE_MAX, patch);
            continue;
        }
        status = add_patch_place(list, context, 0, c->edge[edge].u, SIZE_MAX, patch);
        if (!status)
            status = add_patch_place(list, context, 0, c->edge[edge].v, SIZE_MAX, patch);
    }
    return status;
}

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

static int compare_sizes(size_t a, size_t b) {
    return a < b ? -1 : a > b;
}

static int compare_patch_places(const void *left, const void *right) {
    const patch_place *a = left, *b = right;
    int order = a->is_edge - b->is_edge;
    order = order ? order : compare_sizes(a->cell, b->cell);
    order = order ? order : compare_sizes(a->patch, b->patch);
    return order ? order : compare_sizes(a->facet, b->facet);
}

graze_status places_make(place_list *out, graze_context *context, const graze_patches *p) {
    graze_status status = GRAZE_OK;
    size_t kept = 0;
    memset(out, 0, sizeof *out);
    for (size_t k = 0; k < p->count && !status; k++)
        status = add_patch_places(out, context, &p->envelope->cells, &p->item[k], k);
    if (out->count)
        qsort(out->item, out->count, sizeof *out->item, compare_patch_places);
    for (size_t k = 0; k < out->count; k++)
        if (kept == 0 || compare_patch_places(&out->item[kept - 1], &out->item[k]) != 0)
            out->item[kept++] = out->item[k];
    out->count = kept;
    return status;
}

size_t places_first(const place_list *list, int is_edge, size_t cell) {
    patch_place key = {is_edge, cell, 0, 0};
    size_t low = 0, high = list->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (compare_patch_places(&list->item[middle], &key) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

graze_status members_add(member_set *set, graze_context *context, size_t patch) {
    TRY(array_grow(context, &set->item, &set->capacity, set->count + 1, sizeof *set->item,
                   "the patches of a joint"));
    set->item[set->count++] = patch;
    return GRAZE_OK;
}

static int compare_members(const void *left, const void *right) {
    const size_t *a = left, *b = right;
    return compare_sizes(*a, *b);
}

void members_sort(member_set *set) {
    size_t kept = 0;
    if (set->count)
        qsort(set->item, set->count, sizeof *set->item, compare_members);
    for (size_t k = 0; k < set->count; k++)
        if (kept == 0 || set->item[kept - 1] != set->item[k])
            set->item[kept++] = set->item[k];
    set->count = kept;
}

graze_status joint_add(graze_patches *p, graze_context *context, const graze_cell *cell,
                       graze_chain_form form, size_t from, size_t to, const member_set *set) {
    TRY(array_grow(context, &p->joint, &p->joint_capacity, p->joint_count + 1, sizeof *p->joint,
                   "the joints of patches"));
    TRY(array_grow(context, &p->member, &p->member_capacity, p->member_count + set->count,
                   sizeof *p->member, "the joints of patches"));
    p->joint[p->joint_count++] = (patch_joint){*cell, form, from, to, p->member_count, set->count};
    for (size_t k = 0; k < set->count; k++)
        p->member[p->member_count++] = set->item[k];
    return GRAZE_OK;
}
