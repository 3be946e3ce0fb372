/* Searches the tree of boxes for the simplices next to a point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpq.h>
#include <flint/fmpz_vec.h>
#include <math.h>
#include <stdlib.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "input/solid/solid.h"
#include "input/validate/validate.h"
#include "questions/contact/nearby.h"

/* The simplices whose boxes meet a box, and the smallest extent of these boxes. */
typedef struct neighbours {
    graze_context *context;
    const graze_solid *solid;
    box around;
    uint32_t *item;
    size_t count, capacity;
    double extent;
} neighbours;

static void neighbours_clear(neighbours *n) {
    free(n->item);
}

static graze_status search_around(neighbours *n, size_t index) {
    const tree_node *node = &n->solid->boxes.node[index];
    if (!box_meets(&node->box, &n->around))
        return GRAZE_OK;
    if (node->child) {
        TRY(search_around(n, node->child));
        return search_around(n, node->child + 1);
    }
    n->extent = fmin(n->extent, box_extent(&node->box));
    TRY(array_grow(n->context, &n->item, &n->capacity, n->count + 1, sizeof *n->item,
                   "the facets around a point"));
    n->item[n->count++] = node->simplex;
    return GRAZE_OK;
}

/* Search with the box of half width `half` around the point, rounded outward. */
static graze_status search_box(neighbours *n, const fmpq *point, const fmpq_t half) {
    double unused;
    LOCAL(fmpq, side);
    for (int i = 0; i < n->solid->input.dimension; i++) {
        fmpq_sub(side, point + i, half);
        rational_bounds(&n->around.low[i], &unused, side);
        fmpq_add(side, point + i, half);
        rational_bounds(&unused, &n->around.high[i], side);
    }
    n->count = 0;
    return search_around(n, 0);
}

/* Choose the half width of the box: at most a quarter of the smallest extent found, so that few
 * simplices meet the box. Any number above 0 would be right. */
static void choose_half(fmpq_t half, double extent) {
    int exponent = 0;
    if (extent > 0 && extent < INFINITY)
        frexp(extent, &exponent);
    fmpq_one(half);
    if (exponent >= 3)
        fmpq_mul_2exp(half, half, (ulong)(exponent - 3));
    else
        fmpq_div_2exp(half, half, (ulong)(3 - exponent));
}

/* Append the planes of the box's sides to the list, which has room for them. */
static void set_box_sides(plane_list *list, const fmpq *point, const fmpq_t half) {
    size_t d = (size_t)list->dimension, first = list->count;
    LOCAL(fmpq, at);
    for (size_t k = 0; k < 2 * d; k++) {
        fmpz *form = list->form + (first + k) * (d + 1);
        (k % 2 ? fmpq_add : fmpq_sub)(at, point + k / 2, half);
        fmpz_set(form + k / 2, fmpq_denref(at));
        fmpz_neg(form + d, fmpq_numref(at));
        list->start[first + k + 1] = list->start[first];
    }
    list->count += 2 * d;
}

/* Make room for 2d more planes; 0 when out of memory. */
static int widen_planes(plane_list *list) {
    size_t d = (size_t)list->dimension, more = 2 * d, used = list->count * (d + 1);
    uint32_t *start = realloc(list->start, (list->count + more + 1) * sizeof *start);
    if (!start)
        return 0;
    list->start = start;
    fmpz *form = _fmpz_vec_init((slong)(used + more * (d + 1)));
    _fmpz_vec_swap(form, list->form, (slong)used);
    _fmpz_vec_clear(list->form, (slong)used);
    list->form = form;
    return 1;
}

static graze_status list_planes(plane_list *out, const neighbours *n) {
    if (planes_find(out, NULL, n->solid, n->item, n->count) == 0) {
        for (size_t k = 0; k < n->count; k++)
            out->order[k] = n->item[out->order[k]];
        if (widen_planes(out))
            return GRAZE_OK;
        planes_clear(out);
    }
    return context_fail(n->context, GRAZE_ESYSTEM, "out of memory for the planes around a point");
}

graze_status around_planes(plane_list *out, graze_context *context, const graze_solid *solid,
                           const fmpq *point) {
    ZEROED(neighbours, n);
    LOCAL(fmpq, half);
    n.context = context;
    n.solid = solid;
    n.extent = INFINITY;
    TRY(search_box(&n, point, half));
    choose_half(half, n.extent);
    TRY(search_box(&n, point, half));
    TRY(list_planes(out, &n));
    set_box_sides(out, point, half);
    return GRAZE_OK;
}
