/* Planes are computed and sorted by their coefficients, then equal ones are merged.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _GNU_SOURCE /* qsort_r */
#include "input/solid/solid.h"

#include <flint/fmpz_vec.h>
#include <stdlib.h>

static const fmpz *form_at(const plane_list *list, size_t k) {
    return list->form + k * (size_t)(list->dimension + 1);
}

/* Order entries by their forms, and entries of equal forms by their numbers: no two compare equal,
 * so the order does not depend on whether qsort_r is stable. */
static int compare_entries(const void *left, const void *right, void *list) {
    const plane_list *of = list;
    uint32_t a = *(const uint32_t *)left, b = *(const uint32_t *)right;
    int order = form_compare(form_at(of, a), form_at(of, b), of->dimension);
    return order ? order : a < b ? -1 : a > b;
}

static void compute_forms(plane_list *list, form_memory *forms, const graze_solid *solid,
                          const uint32_t *simplex) {
    slong width = list->dimension + 1;
    list->form = _fmpz_vec_init((slong)list->simplex_count * width);
    for (size_t k = 0; k < list->simplex_count; k++) {
        fmpz *form = list->form + k * (size_t)width;
        if (simplex && k > 0 && simplex[k] == simplex[k - 1])
            _fmpz_vec_set(form, form - width, width);
        else
            known_plane(form, forms, solid, simplex ? simplex[k] : (uint32_t)k);
    }
}

/* Number the planes along the sorted entries, and keep one form for each. */
static void share(plane_list *list) {
    size_t n = list->simplex_count, width = (size_t)list->dimension + 1;
    for (size_t k = 0; k < n; k++)
        if (k == 0 || form_compare(form_at(list, list->order[k - 1]), form_at(list, list->order[k]),
                                   list->dimension) != 0)
            list->start[list->count++] = (uint32_t)k;
    list->start[list->count] = (uint32_t)n;
    fmpz *kept = _fmpz_vec_init((slong)(list->count * width));
    for (size_t p = 0; p < list->count; p++)
        _fmpz_vec_swap(kept + p * width, list->form + list->order[list->start[p]] * width,
                       (slong)width);
    _fmpz_vec_clear(list->form, (slong)(n * width));
    list->form = kept;
}

int planes_find(plane_list *out, form_memory *forms, const graze_solid *solid,
                const uint32_t *simplex, size_t count) {
    *out = (plane_list){.simplex_count = count, .dimension = solid->input.dimension};
    out->order = malloc((count + 1) * sizeof *out->order);
    out->start = malloc((count + 1) * sizeof *out->start);
    if (!out->order || !out->start) {
        planes_clear(out);
        return -1;
    }
    for (size_t k = 0; k < count; k++)
        out->order[k] = (uint32_t)k;
    compute_forms(out, forms, solid, simplex);
    qsort_r(out->order, count, sizeof *out->order, compare_entries, out);
    share(out);
    return 0;
}

void planes_clear(plane_list *list) {
    if (list->form)
        _fmpz_vec_clear(list->form, (slong)(list->count * (size_t)(list->dimension + 1)));
    free(list->order);
    free(list->start);
    *list = (plane_list){.count = 0};
}
