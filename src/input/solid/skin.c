/* Bounds, boxes and forms of simplices.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/solid/solid.h"

#include "base/context/scope.h"
#include "base/number/rounding.h"

graze_status skin_bounds(double **low, double **high, graze_context *context, const soup *input) {
    size_t n = input->vertex_count * (size_t)input->dimension;
    *low = malloc((n + 1) * sizeof **low);
    *high = malloc((n + 1) * sizeof **high);
    if (!*low || !*high)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for %zu coordinates", n);
    for (size_t k = 0; k < n; k++)
        rational_bounds(&(*low)[k], &(*high)[k], input->coordinates + k);
    return GRAZE_OK;
}

static void bound_simplex(box *out, const skin *s, size_t simplex) {
    size_t d = (size_t)s->input->dimension;
    *out = (box){{0, 0, 0}, {0, 0, 0}};
    for (size_t k = 0; k < d; k++) {
        size_t at = s->cut->item[simplex].vertex[k] * d;
        for (size_t i = 0; i < d; i++) {
            if (k == 0 || s->low[at + i] < out->low[i])
                out->low[i] = s->low[at + i];
            if (k == 0 || s->high[at + i] > out->high[i])
                out->high[i] = s->high[at + i];
        }
    }
}

graze_status skin_tree(tree *out, graze_context *context, const skin *s) {
    size_t n = s->cut->count;
    *out = (tree){0, NULL};
    if (!n)
        return GRAZE_OK;
    FREED(box, boxes, malloc(n * sizeof *boxes));
    for (size_t k = 0; k < n && boxes; k++)
        bound_simplex(&boxes[k], s, k);
    return !boxes || tree_build(out, boxes, n)
               ? context_fail(context, GRAZE_ESYSTEM, "out of memory for a tree of %zu boxes", n)
               : GRAZE_OK;
}

void skin_vertices(const fmpq **vertex, const skin *s, size_t simplex) {
    size_t d = (size_t)s->input->dimension;
    for (size_t k = 0; k < d; k++)
        vertex[k] = s->input->coordinates + s->cut->item[simplex].vertex[k] * d;
}

int skin_plane(fmpz *out, const skin *s, size_t simplex) {
    const fmpq *vertex[3];
    skin_vertices(vertex, s, simplex);
    return form_of_plane(out, vertex, s->input->dimension);
}

void skin_side(fmpz *out, const skin *s, size_t simplex, const fmpz *plane, int k) {
    const fmpq *vertex[3];
    skin_vertices(vertex, s, simplex);
    form_of_side(out, vertex, plane, k, s->input->dimension);
}
