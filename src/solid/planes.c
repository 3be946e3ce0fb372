/* Planes are computed, sorted by their coefficients, and equal ones made one.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "solid/planes.h"

#include <flint/fmpz_vec.h>
#include <stdlib.h>
#include <string.h>
#include "solid/forms.h"

static const fmpz *form_at(const plane_list *list, size_t k) {
    return list->form + k * (size_t)(list->dimension + 1);
}

/* Merge sort of entries by their forms, ascending where those are equal; qsort has no place for the
 * forms. */
static void sort(const plane_list *list, uint32_t *order, uint32_t *scratch, size_t n) {
    if (n < 2)
        return;
    size_t half = n / 2, i = 0, j = half, k = 0;
    sort(list, order, scratch, half);
    sort(list, order + half, scratch, n - half);
    memcpy(scratch, order, n * sizeof *order);
    while (i < half || j < n) {
        int left =
            j == n || (i < half && form_compare(form_at(list, scratch[i]),
                                                form_at(list, scratch[j]), list->dimension) <= 0);
        order[k++] = left ? scratch[i++] : scratch[j++];
    }
}

static void compute_forms(plane_list *list, const graze_solid *solid, const uint32_t *simplex) {
    slong width = list->dimension + 1;
    list->form = _fmpz_vec_init((slong)list->simplex_count * width);
    for (size_t k = 0; k < list->simplex_count; k++) {
        fmpz *form = list->form + k * (size_t)width;
        if (simplex && k > 0 && simplex[k] == simplex[k - 1])
            _fmpz_vec_set(form, form - width, width);
        else
            solid_plane(form, solid, simplex ? simplex[k] : k);
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

int planes_find(plane_list *out, const graze_solid *solid, const uint32_t *simplex, size_t count) {
    *out = (plane_list){.simplex_count = count, .dimension = solid->input.dimension};
    uint32_t *scratch = malloc((count + 1) * sizeof *scratch);
    out->order = malloc((count + 1) * sizeof *out->order);
    out->start = malloc((count + 1) * sizeof *out->start);
    int enough = scratch && out->order && out->start;
    if (enough) {
        for (size_t k = 0; k < count; k++)
            out->order[k] = (uint32_t)k;
        compute_forms(out, solid, simplex);
        sort(out, out->order, scratch, count);
        share(out);
    } else {
        planes_clear(out);
    }
    free(scratch);
    return enough ? 0 : -1;
}

void planes_clear(plane_list *list) {
    if (list->form)
        _fmpz_vec_clear(list->form, (slong)(list->count * (size_t)(list->dimension + 1)));
    free(list->order);
    free(list->start);
    *list = (plane_list){.count = 0};
}
