/* Stretches of an edge that are in contact: between the zeros of g of its two facets the signs do
 * not change. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/contact/nearby.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

/* The places that bound stretches are at most the two ends of the edge and, for each of two facets
 * and each side of the time, one zero of g. */
enum { RUN_PARTS = 6 };

/* The edge from u to v. `part`: bounds of stretches, as fractions of the way from u to v. `normal`:
 * the normals of both facets, equal at a flat edge. */
typedef struct edge_run {
    const fmpq *u, *v;
    const site_side *side;
    int reflex;
    const fmpz *normal[2];
    size_t count;
    fmpq *part; /* ascending */
} edge_run;

static int sign_of_form_at(const fmpz *form, const fmpq *corner) {
    LOCAL_VEC(fmpz, x, 4);
    _fmpq_vec_get_fmpz_vec_fmpz(x, x + 3, corner, 3);
    return form_sign(form, x, 3);
}

/* Is some corner of a simplex on the outer side of a plane? */
static int leads_outside(const graze_solid *solid, size_t simplex, const fmpz *form) {
    int outside = 0;
    for (int k = 0; k < 3; k++)
        outside |= sign_of_form_at(form, solid_corner(solid, simplex, k)) > 0;
    return outside;
}

/* Take those facets at the middle of the edge whose planes contain the edge. */
static graze_status take_facets(edge_run *r, graze_context *context, const graze_solid *solid,
                                const neighborhood *p) {
    const place_facet *facet[2] = {NULL, NULL};
    int count = 0;
    for (size_t k = 0; k < p->count; k++)
        if (!sign_of_form_at(p->facet[k].form, r->u) && !sign_of_form_at(p->facet[k].form, r->v)) {
            if (count < 2)
                facet[count] = &p->facet[k];
            count++;
        }
    if (count < 1 || count > 2)
        return context_fail(context, GRAZE_EINPUT,
                            "%d facets meet along the edge; expected an edge between two", count);
    for (int j = 0; j < 2; j++)
        r->normal[j] = facet[j < count ? j : 0]->normal;
    r->reflex = count == 2 && leads_outside(solid, facet[0]->simplex, facet[1]->form);
    return GRAZE_OK;
}

/* Add the place at which g of a facet is 0 on a side, if it changes its sign inside the edge. */
static void add_zero(edge_run *r, int side, int facet) {
    LOCAL_VEC(fmpq, at_u, 2);
    fmpq *at_v = at_u + 1;
    sides_speed(at_u, r->side, side, r->normal[facet], r->u);
    sides_speed(at_v, r->side, side, r->normal[facet], r->v);
    if (fmpq_sgn(at_u) * fmpq_sgn(at_v) < 0) {
        fmpq_sub(at_v, at_u, at_v);
        fmpq_div(r->part + r->count++, at_u, at_v);
    }
}

/* Is a point of the edge in contact, by the signs of g of the edge's facets? */
static int is_in_contact(const edge_run *r, const fmpq *y) {
    int holds = 1;
    LOCAL(fmpq, g);
    for (int side = 0; side < 2 && holds; side++) {
        int good = 0;
        if (!r->side[side].present)
            continue;
        for (int j = 0; j < 2; j++) {
            sides_speed(g, r->side, side, r->normal[j], y);
            good += side ? fmpq_sgn(g) <= 0 : fmpq_sgn(g) >= 0;
        }
        holds = good > r->reflex;
    }
    return holds;
}

/* Try the stretches that are in contact, and the points between stretches that are. */
static void try_stretches(nearby *n, const edge_run *r) {
    LOCAL_VEC(fmpq, here, 9);
    fmpq *before = here + 3, *middle = before + 3;
    LOCAL(fmpq, half);
    for (size_t k = 0; k < r->count; k++) {
        vector_between(here, r->u, r->v, r->part + k, 3);
        if (is_in_contact(r, here))
            nearby_try(n, here);
        if (k > 0) {
            vector_middle(half, r->part + k - 1, r->part + k, 1);
            vector_between(middle, r->u, r->v, half, 3);
            if (is_in_contact(r, middle))
                nearby_try_segment(n, before, here);
        }
        vector_set(before, here, 3);
    }
}

graze_status edge_run_try(nearby *n, graze_context *context, const graze_solid *solid,
                          const fmpq *u, const fmpq *v, const site_side side[2]) {
    LOCAL_VEC(fmpq, part, RUN_PARTS);
    LOCAL_VEC(fmpq, middle, 3);
    ZEROED(neighborhood, p);
    edge_run r = {.u = u, .v = v, .side = side, .count = 2, .part = part};
    vector_middle(middle, u, v, 3);
    TRY(neighborhood_locate(&p, context, solid, middle));
    TRY(take_facets(&r, context, solid, &p));
    fmpq_one(part + 1);
    for (int k = 0; k < 2; k++)
        for (int j = 0; j < 2 && side[k].present; j++)
            add_zero(&r, k, j);
    _fmpq_vec_sort(part, (slong)r.count);
    try_stretches(n, &r);
    return GRAZE_OK;
}
