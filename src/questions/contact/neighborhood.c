/* Facets that contain a point, found through the solid's tree, and the kind of the cone they bound.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Near the point, a simplex that contains it is the cone of the directions to the simplex's
 * corners. If no such direction lies outside any of the facets' planes, the solid near the point is
 * the intersection of the planes' inner sides; if no direction lies inside any, the union
 * (proofs/envelope.md C57).
 */
#include "questions/contact/contact.h"

#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/rounding.h"

typedef struct place_finder {
    neighborhood *out;
    graze_context *context;
    const graze_solid *solid;
    fmpz *x; /* the point: d + 1 homogeneous integers */
    box around;
    size_t *simplex; /* the simplices that contain the point */
    size_t simplex_count, simplex_capacity;
} place_finder;

/* Has cell a less dimension than cell b or, if the dimensions are equal, smaller numbers? */
static int is_lower(const graze_cell *a, const graze_cell *b) {
    return a->kind != b->kind ? a->kind > b->kind : cell_compare(a, b) < 0;
}

static void name_cell(place_finder *f, size_t simplex, unsigned zero) {
    size_t count;
    graze_cell given = solid_cell(f->solid, simplex, zero);
    const graze_cell *name = cell_names_of(&count, &f->solid->cut.names, &given);
    if (f->simplex_count == 0 || is_lower(name, &f->out->cell))
        f->out->cell = *name;
}

/* Is this facet with this plane in the list? */
static int is_known(const neighborhood *p, const graze_cell *name, const fmpz *outward) {
    for (size_t k = 0; k < p->count; k++)
        if (cell_compare(&p->facet[k].name, name) == 0 &&
            _fmpz_vec_equal(p->facet[k].form, outward, p->dimension + 1))
            return 1;
    return 0;
}

static graze_status add_facet_here(place_finder *f, size_t simplex, const fmpz *outward) {
    neighborhood *p = f->out;
    int d = p->dimension;
    graze_cell name = solid_cell(f->solid, simplex, 0);
    if (is_known(p, &name, outward))
        return GRAZE_OK;
    TRY(ARRAY_GROW(f->context, p->facet, p->capacity, p->count + 1, "the facets at a point"));
    place_facet *made = &p->facet[p->count++];
    *made = (place_facet){.name = name, .simplex = simplex, .form = _fmpz_vec_init(7)};
    made->normal = made->form + 4;
    _fmpz_vec_set(made->form, outward, d + 1);
    LOCAL(fmpz, content);
    _fmpz_vec_content(content, made->form, d);
    _fmpz_vec_scalar_divexact_fmpz(made->normal, made->form, d, content);
    return GRAZE_OK;
}

/* Take a simplex if it contains the point. */
static graze_status try_simplex(place_finder *f, size_t simplex) {
    int d = f->out->dimension;
    unsigned zero = 0;
    LOCAL_VEC(fmpz, plane, d + 1);
    int facing = solid_plane(plane, f->solid, simplex);
    if (form_sign(plane, f->x, d) == 0 && solid_holds(&zero, f->solid, simplex, plane, f->x)) {
        name_cell(f, simplex, zero);
        TRY(ARRAY_GROW(f->context, f->simplex, f->simplex_capacity, f->simplex_count + 1,
                       "the facets at a point"));
        f->simplex[f->simplex_count++] = simplex;
        _fmpz_vec_scalar_mul_si(plane, plane, d + 1, facing);
        TRY(add_facet_here(f, simplex, plane));
    }
    return GRAZE_OK;
}

static graze_status search_place(place_finder *f, size_t index) {
    const tree_node *node = &f->solid->boxes.node[index];
    if (!box_meets(&node->box, &f->around))
        return GRAZE_OK;
    if (!node->child)
        return try_simplex(f, node->simplex);
    TRY(search_place(f, node->child));
    return search_place(f, node->child + 1);
}

/* Note whether directions from the point to corners of a simplex lead to the outer side or to the
 * inner side of some facet's plane. */
static void look_at_corners(int *outside, int *inside, const place_finder *f, size_t simplex) {
    int d = f->out->dimension;
    LOCAL_VEC(fmpz, corner, d + 1);
    for (int k = 0; k < d; k++) {
        _fmpq_vec_get_fmpz_vec_fmpz(corner, corner + d, solid_corner(f->solid, simplex, k), d);
        for (size_t j = 0; j < f->out->count; j++) {
            int sign = form_sign(f->out->facet[j].form, corner, d);
            *outside |= sign > 0;
            *inside |= sign < 0;
        }
    }
}

static void find_cone_kind(place_finder *f) {
    int outside = 0, inside = 0;
    for (size_t k = 0; k < f->simplex_count && !(outside && inside); k++)
        look_at_corners(&outside, &inside, f, f->simplex[k]);
    f->out->kind = !outside && !inside ? PLACE_FACET
                   : !outside          ? PLACE_CONVEX
                   : !inside           ? PLACE_REFLEX
                                       : PLACE_OTHER;
}

static int compare_facets(const void *left, const void *right) {
    const place_facet *a = left, *b = right;
    int order = cell_compare(&a->name, &b->name);
    return order ? order : a->simplex < b->simplex ? -1 : a->simplex > b->simplex;
}

graze_status neighborhood_locate(neighborhood *out, graze_context *context,
                                 const graze_solid *solid, const fmpq *point) {
    int d = solid->input.dimension;
    place_finder f = {.out = out, .context = context, .solid = solid};
    memset(out, 0, sizeof *out);
    out->dimension = d;
    LOCAL_VEC(fmpz, x, d + 1);
    f.x = x;
    _fmpq_vec_get_fmpz_vec_fmpz(x, x + d, point, d);
    for (int i = 0; i < d; i++)
        rational_bounds(&f.around.low[i], &f.around.high[i], point + i);
    graze_status status = search_place(&f, 0);
    if (!status && out->count) {
        find_cone_kind(&f);
        qsort(out->facet, out->count, sizeof *out->facet, compare_facets);
    }
    free(f.simplex);
    return status;
}

void neighborhood_clear(neighborhood *p) {
    for (size_t k = 0; k < p->count; k++)
        _fmpz_vec_clear(p->facet[k].form, 7);
    free(p->facet);
    *p = (neighborhood){.count = 0};
}
