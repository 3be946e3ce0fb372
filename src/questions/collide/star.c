/* The tree is searched with the edge's box; the signs of planes and sides at the point decide.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "questions/collide/placing.h"

typedef struct finder {
    star *out;
    placing *p;
    pair_side side;
    const graze_solid *solid;
    box box;
    trajectory at; /* the point */
} finder;

static int form_sign_there(finder *f, const fmpz *form) {
    trajectory_pullback(f->p->value, &f->at, form);
    return placing_sign(f->p, f->p->value);
}

static void look_at_simplex(finder *f, uint32_t simplex) {
    star_simplex found = {.simplex = simplex};
    fmpz *plane = f->p->room;
    form_memory *forms = f->p->pair->forms[f->side];
    known_plane(plane, forms, f->solid, simplex);
    int held = form_sign_there(f, plane) == 0;
    for (int k = 0; k < f->solid->input.dimension && held; k++) {
        int sign = form_sign_there(f, known_side(plane + 4, forms, f->solid, simplex, plane, k));
        held = sign >= 0;
        found.zero |= sign == 0 ? 1u << k : 0;
    }
    if (held && PLACING_ROOM(f->p, f->out, "simplices at a point"))
        f->out->item[f->out->count++] = found;
}

static void descend_star(finder *f, uint32_t node) {
    const tree_node *n = &f->solid->boxes.node[node];
    if (f->p->status || !box_meets(&f->box, &n->box))
        return;
    if (!n->child) {
        look_at_simplex(f, n->simplex);
        return;
    }
    descend_star(f, n->child);
    descend_star(f, n->child + 1);
}

/* Set the point as d + 1 polynomials: the sum of the ends, over a common denominator, times their
 * shares. */
static void place_point(finder *f, const uint32_t edge[2], const fmpz_poly_struct share[2]) {
    slong d = f->solid->input.dimension;
    int ends = edge[0] == edge[1] ? 1 : 2;
    LOCAL_VEC(fmpq, end, 2 * d);
    LOCAL_VEC(fmpz, entry, 2 * d + 1);
    LOCAL(fmpz_poly, term);
    for (int k = 0; k < 2; k++)
        for (slong i = 0; i < d; i++)
            fmpq_set(end + k * d + i, f->solid->input.coordinates + edge[k] * (size_t)d + i);
    _fmpq_vec_get_fmpz_vec_fmpz(entry, entry + 2 * d, end, 2 * d);
    for (slong i = 0; i <= d; i++)
        for (int k = 0; k < ends; k++) {
            const fmpz *value = i < d ? entry + k * d + i : entry + 2 * d;
            if (ends == 1)
                fmpz_poly_set_fmpz(term, value);
            else
                fmpz_poly_scalar_mul_fmpz(term, &share[k], value);
            fmpz_poly_add(&f->at.x[i], &f->at.x[i], term);
        }
}

void star_find(star *out, placing *p, pair_side side, const uint32_t edge[2],
               const fmpz_poly_struct share[2]) {
    finder f = {.out = out, .p = p, .side = side, .solid = placing_solid(p, side)};
    int d = f.solid->input.dimension;
    const double *low = f.solid->low, *high = f.solid->high;
    for (int i = 0; i < d; i++) {
        size_t a = edge[0] * (size_t)d + (size_t)i, b = edge[1] * (size_t)d + (size_t)i;
        f.box.low[i] = low[a] < low[b] ? low[a] : low[b];
        f.box.high[i] = high[a] > high[b] ? high[a] : high[b];
    }
    trajectory_init(&f.at, d);
    place_point(&f, edge, share);
    out->count = 0;
    descend_star(&f, 0);
    trajectory_clear(&f.at);
}
