/* From a soup to a solid: validation, forms, boxes, tree, side tests.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "solid/solid.h"

#include <flint/fmpz_vec.h>
#include <stdlib.h>
#include <string.h>
#include "number/rational.h"
#include "solid/forms.h"

const fmpz *solid_plane(const graze_solid *solid, size_t simplex) {
    return solid->plane + (size_t)solid->plane_of[simplex] * (size_t)(solid->input.dimension + 1);
}

const fmpz *solid_side(const graze_solid *solid, size_t simplex, int k) {
    size_t d = (size_t)solid->input.dimension;
    return solid->side + (simplex * d + (size_t)k) * (d + 1);
}

int form_sign(const fmpz *form, const fmpz *x, int dimension) {
    fmpz_t value;
    fmpz_init(value);
    _fmpz_vec_dot(value, form, x, dimension + 1);
    int sign = fmpz_sgn(value);
    fmpz_clear(value);
    return sign;
}

/* The coordinates of a simplex's vertices. */
static void vertices_of(const fmpq **vertex, const graze_solid *solid, size_t simplex) {
    size_t d = (size_t)solid->input.dimension;
    for (size_t k = 0; k < d; k++)
        vertex[k] = solid->input.coordinates + solid->cut.item[simplex].vertex[k] * d;
}

/* Turn a plane form so that its first non-zero coordinate is positive; -1 if that changed its sign.
 */
static signed char normalise(fmpz *form, int dimension) {
    int i = 0;
    while (fmpz_is_zero(form + i))
        i++;
    if (fmpz_sgn(form + i) > 0)
        return 1;
    _fmpz_vec_neg(form, form, dimension + 1);
    return -1;
}

static int compare_forms(const fmpz *a, const fmpz *b, int dimension) {
    for (int i = 0; i <= dimension; i++) {
        int c = fmpz_cmp(a + i, b + i);
        if (c != 0)
            return c;
    }
    return 0;
}

/* Merge sort of plane indices by their forms; qsort has no place for the forms. */
static void sort_planes(uint32_t *order, uint32_t *scratch, size_t n, const fmpz *forms,
                        int dimension) {
    if (n < 2)
        return;
    size_t half = n / 2, width = (size_t)dimension + 1, i = 0, j = half, k = 0;
    sort_planes(order, scratch, half, forms, dimension);
    sort_planes(order + half, scratch, n - half, forms, dimension);
    memcpy(scratch, order, n * sizeof *order);
    while (i < half || j < n) {
        int left =
            j == n || (i < half && compare_forms(forms + scratch[i] * width,
                                                 forms + scratch[j] * width, dimension) <= 0);
        order[k++] = left ? scratch[i++] : scratch[j++];
    }
}

/* Keep each plane once: forms[s] is simplex s's plane on entry. */
static void share_planes(graze_solid *solid, fmpz *forms, uint32_t *order, uint32_t *scratch) {
    size_t n = solid->cut.count, width = (size_t)solid->input.dimension + 1;
    for (size_t s = 0; s < n; s++)
        order[s] = (uint32_t)s;
    sort_planes(order, scratch, n, forms, solid->input.dimension);
    size_t count = 0;
    for (size_t k = 0; k < n; k++) {
        if (k == 0 || compare_forms(forms + order[k] * width, forms + order[k - 1] * width,
                                    solid->input.dimension) != 0)
            count++;
        solid->plane_of[order[k]] = (uint32_t)(count - 1);
    }
    solid->plane_count = count;
    solid->plane = _fmpz_vec_init((slong)(count * width));
    for (size_t s = 0; s < n; s++)
        _fmpz_vec_set(solid->plane + solid->plane_of[s] * width, forms + s * width, (slong)width);
}

static graze_status make_forms(graze_solid *solid, graze_context *context) {
    int d = solid->input.dimension;
    size_t n = solid->cut.count, width = (size_t)d + 1;
    uint32_t *order = malloc(n * sizeof *order), *scratch = malloc(n * sizeof *scratch);
    solid->plane_of = malloc(n * sizeof *solid->plane_of);
    solid->facing = malloc(n);
    graze_status status = GRAZE_OK;
    if (!order || !scratch || !solid->plane_of || !solid->facing) {
        status = context_fail(context, GRAZE_ESYSTEM, "out of memory for %zu boundary pieces", n);
    } else {
        fmpz *forms = _fmpz_vec_init((slong)(n * width));
        solid->side = _fmpz_vec_init((slong)(n * width * (size_t)d));
        for (size_t s = 0; s < n; s++) {
            const fmpq *vertex[3];
            vertices_of(vertex, solid, s);
            form_of_plane(forms + s * width, vertex, d);
            solid->facing[s] = normalise(forms + s * width, d);
            for (int k = 0; k < d; k++)
                form_of_side(solid->side + (s * (size_t)d + (size_t)k) * width, vertex,
                             forms + s * width, k, d);
        }
        share_planes(solid, forms, order, scratch);
        _fmpz_vec_clear(forms, (slong)(n * width));
    }
    free(order);
    free(scratch);
    return status;
}

static void bound_simplex(box *out, const graze_solid *solid, size_t simplex) {
    int d = solid->input.dimension;
    const fmpq *vertex[3];
    vertices_of(vertex, solid, simplex);
    *out = (box){{0, 0, 0}, {0, 0, 0}};
    for (int i = 0; i < d; i++)
        for (int k = 0; k < d; k++) {
            double low, high;
            rational_bounds(&low, &high, vertex[k] + i);
            if (k == 0 || low < out->low[i])
                out->low[i] = low;
            if (k == 0 || high > out->high[i])
                out->high[i] = high;
        }
}

static graze_status make_tree(graze_solid *solid, graze_context *context) {
    size_t n = solid->cut.count;
    box *boxes = malloc(n * sizeof *boxes);
    int failed = !boxes;
    if (boxes) {
        for (size_t s = 0; s < n; s++)
            bound_simplex(&boxes[s], solid, s);
        failed = tree_build(&solid->boxes, boxes, n);
    }
    free(boxes);
    return failed ? context_fail(context, GRAZE_ESYSTEM, "out of memory for a tree of %zu boxes", n)
                  : GRAZE_OK;
}

graze_status solid_create(graze_solid **out, graze_context *context, soup *input, unsigned flags) {
    *out = NULL;
    graze_solid *solid = calloc(1, sizeof *solid);
    if (!solid) {
        soup_clear(input);
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a solid");
    }
    solid->input = *input;
    graze_status status = validate_soup(&solid->cut, context, &solid->input, flags);
    if (status == GRAZE_OK)
        status = make_forms(solid, context);
    if (status == GRAZE_OK)
        status = make_tree(solid, context);
    if (status == GRAZE_OK)
        status = corners_make(&solid->corners, context, &solid->input, &solid->cut);
    if (status == GRAZE_OK)
        status = solid_check_sides(solid, context);
    if (status == GRAZE_OK)
        *out = solid;
    else
        graze_solid_destroy(solid);
    return status;
}

void graze_solid_destroy(graze_solid *solid) {
    if (!solid)
        return;
    size_t d = (size_t)solid->input.dimension;
    if (solid->side)
        _fmpz_vec_clear(solid->side, (slong)(solid->cut.count * d * (d + 1)));
    if (solid->plane)
        _fmpz_vec_clear(solid->plane, (slong)(solid->plane_count * (d + 1)));
    free(solid->plane_of);
    free(solid->facing);
    tree_clear(&solid->boxes);
    corners_clear(&solid->corners);
    free(solid->cut.item);
    soup_clear(&solid->input);
    free(solid);
}

/* Sides vanish in one place each: E^2 none or the vertex k; E^3 the edge k, or the vertex two edges
 * share. */
graze_cell solid_cell(const graze_solid *solid, size_t simplex, unsigned zero) {
    const struct simplex *s = &solid->cut.item[simplex];
    if (solid->input.dimension == 2) {
        if (zero)
            return (graze_cell){GRAZE_CELL_VERTEX, s->vertex[zero == 1 ? 0 : 1], 0};
        size_t u = s->vertex[0], v = s->vertex[1];
        return (graze_cell){GRAZE_CELL_EDGE, u < v ? u : v, u < v ? v : u};
    }
    for (int k = 0; k < 3; k++) {
        unsigned here = 1u << k, before = 1u << (k + 2) % 3;
        if (zero == (here | before))
            return (graze_cell){GRAZE_CELL_VERTEX, s->vertex[k], 0};
        if (zero == here && !(s->diagonal & here)) {
            size_t u = s->vertex[k], v = s->vertex[(k + 1) % 3];
            return (graze_cell){GRAZE_CELL_EDGE, u < v ? u : v, u < v ? v : u};
        }
    }
    return (graze_cell){GRAZE_CELL_FACE, s->facet, 0};
}
