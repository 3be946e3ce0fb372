/* Stretches of an edge that are in contact: between the zeros of g of its two facets the signs do
 * not change. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/contact/contact.h"

#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include <stdlib.h>
#include "base/context/scope.h"
#include "input/solid/solid.h"
#include "input/validate/validate.h"
#include "questions/contact/nearby.h"

/* The places that bound stretches are at most the two ends of the edge and, for each of two facets
 * and each side of the time, one zero of g. */
enum { RUN_PARTS = 6 };

/* The edge from u to v. `part`: bounds of stretches, as fractions of the way from u to v. `normal`:
 * the normals of both facets, 3 entries each, equal at a flat edge. */
typedef struct edge_run {
    const fmpq *u, *v;
    const speed *speed;
    int reflex;
    fmpq *normal;
    size_t count;
    fmpq *part; /* ascending */
} edge_run;

static int sign_of_form_at(const fmpz *form, const fmpq *corner) {
    LOCAL_VEC(fmpz, x, 4);
    _fmpq_vec_get_fmpz_vec_fmpz(x, x + 3, corner, 3);
    return form_sign(form, x, 3);
}

static void edge_point_at(fmpq *out, const edge_run *r, const fmpq_t part) {
    LOCAL(fmpq, step);
    for (int i = 0; i < 3; i++) {
        fmpq_sub(step, r->v + i, r->u + i);
        fmpq_set(out + i, r->u + i);
        fmpq_addmul(out + i, part, step);
    }
}

/* Is some corner of a simplex on the outer side of a plane? */
static int leads_outside(const graze_solid *solid, size_t simplex, const fmpz *form) {
    int outside = 0;
    for (int k = 0; k < 3; k++)
        outside |= sign_of_form_at(form, solid->input.coordinates +
                                             solid->cut.item[simplex].vertex[k] * (size_t)3) > 0;
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
        for (int i = 0; i < 3; i++)
            fmpz_set(fmpq_numref(r->normal + 3 * j + i), facet[j < count ? j : 0]->normal + i);
    r->reflex = count == 2 && leads_outside(solid, facet[0]->simplex, facet[1]->form);
    return GRAZE_OK;
}

static int compare_parts(const void *a, const void *b) {
    return fmpq_cmp((const fmpq *)a, (const fmpq *)b);
}

/* Add the place at which g of a facet is 0 on a side, if it changes its sign inside the edge. */
static void add_zero(edge_run *r, int side, int facet) {
    LOCAL_VEC(fmpq, at_u, 2);
    fmpq *at_v = at_u + 1;
    speed_along(at_u, r->speed, side, r->normal + 3 * facet, r->u);
    speed_along(at_v, r->speed, side, r->normal + 3 * facet, r->v);
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
        if (!r->speed->present[side])
            continue;
        for (int j = 0; j < 2; j++) {
            speed_along(g, r->speed, side, r->normal + 3 * j, y);
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
        edge_point_at(here, r, r->part + k);
        if (is_in_contact(r, here))
            nearby_try(n, here);
        if (k > 0) {
            fmpq_add(half, r->part + k - 1, r->part + k);
            fmpq_div_2exp(half, half, 1);
            edge_point_at(middle, r, half);
            if (is_in_contact(r, middle))
                nearby_try_segment(n, before, here);
        }
        for (int i = 0; i < 3; i++)
            fmpq_set(before + i, here + i);
    }
}

graze_status edge_run_try(nearby *n, graze_context *context, const graze_solid *solid,
                          const fmpq *u, const fmpq *v, const speed *s) {
    LOCAL_VEC(fmpq, normal, 6);
    LOCAL_VEC(fmpq, part, RUN_PARTS);
    LOCAL_VEC(fmpq, middle, 3);
    ZEROED(neighborhood, p);
    edge_run r = {.u = u, .v = v, .speed = s, .normal = normal, .count = 2, .part = part};
    edge_point_at(middle, &r, &(fmpq){1, 2});
    TRY(neighborhood_locate(&p, context, solid, middle));
    TRY(take_facets(&r, context, solid, &p));
    fmpq_one(part + 1);
    for (int side = 0; side < 2; side++)
        for (int j = 0; j < 2 && s->present[side]; j++)
            add_zero(&r, side, j);
    qsort(part, r.count, sizeof *part, compare_parts);
    try_stretches(n, &r);
    return GRAZE_OK;
}
