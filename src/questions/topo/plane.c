/* Coordinates of planes and lists of curves. SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "questions/topo/cover.h"

void plane_view_init(plane_view *view) {
    *view = (plane_view){2, {{0, 1}, {0, 1}, {0, 1}}, {{1, 0, 0}, {0, 1, 0}}};
}

void view_set_through(plane_view *view, const fmpq *point, const fmpz *a, const fmpz *b) {
    view->dimension = 3;
    for (int i = 0; i < 3; i++) {
        fmpq_set(view->origin + i, point + i);
        fmpz_set(view->along[0] + i, a + i);
        fmpz_set(view->along[1] + i, b + i);
    }
}

void plane_view_clear(plane_view *view) {
    for (int i = 0; i < 3; i++) {
        fmpq_clear(view->origin + i);
        for (int k = 0; k < 2; k++)
            fmpz_clear(view->along[k] + i);
    }
}

void view_point(fmpq *out, const plane_view *view, const fmpq *xy) {
    LOCAL(fmpq, way);
    for (int i = 0; i < view->dimension; i++) {
        fmpq_set(out + i, view->origin + i);
        for (int k = 0; k < 2; k++) {
            fmpq_mul_fmpz(way, xy + k, view->along[k] + i);
            fmpq_add(out + i, out + i, way);
        }
    }
}

void curve_list_init(curve_list *list) {
    memset(list, 0, sizeof *list);
    fmpz_mpoly_ctx_init(list->ring, RING_VARIABLES, ORD_LEX);
}

void curve_list_clear(curve_list *list) {
    for (size_t k = 0; k < list->count; k++)
        fmpz_mpoly_clear(&list->item[k], list->ring);
    free(list->item);
    fmpz_mpoly_ctx_clear(list->ring);
}

graze_status curves_append(curve_list *list, graze_context *context, const fmpz_mpoly_t curve) {
    if (fmpz_mpoly_is_fmpz(curve, list->ring))
        return GRAZE_OK;
    TRY(array_grow(context, &list->item, &list->capacity, list->count + 1, sizeof *list->item,
                   "the curves of a sweep"));
    fmpz_mpoly_init(&list->item[list->count], list->ring);
    fmpz_mpoly_set(&list->item[list->count++], curve, list->ring);
    return GRAZE_OK;
}
