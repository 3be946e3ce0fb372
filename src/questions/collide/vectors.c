/* Vectors that are polynomials in u: products, and edges of placed solids.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "questions/collide/features.h"

void moving_vector_init(moving_vector *v) {
    for (int i = 0; i < 3; i++)
        fmpz_poly_init(&v->c[i]);
}

void moving_vector_clear(moving_vector *v) {
    for (int i = 0; i < 3; i++)
        fmpz_poly_clear(&v->c[i]);
}

void moving_set(moving_vector *out, const moving_vector *v) {
    for (int i = 0; i < 3; i++)
        fmpz_poly_set(&out->c[i], &v->c[i]);
}

void moving_negate(moving_vector *v) {
    for (int i = 0; i < 3; i++)
        fmpz_poly_neg(&v->c[i], &v->c[i]);
}

void dot_moving(fmpz_poly_t out, const moving_vector *a, const moving_vector *b) {
    LOCAL(fmpz_poly, term);
    fmpz_poly_zero(out);
    for (int i = 0; i < 3; i++) {
        fmpz_poly_mul(term, &a->c[i], &b->c[i]);
        fmpz_poly_add(out, out, term);
    }
}

/* out = a x b; `out` is neither. */
void cross_moving(moving_vector *out, const moving_vector *a, const moving_vector *b) {
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        cross_terms(&out->c[i], &a->c[j], &a->c[k], &b->c[j], &b->c[k]);
    }
}

void edge_vector(moving_vector *out, placing *p, pair_side side, uint32_t simplex, int a, int b) {
    const graze_solid *solid = placing_solid(p, side);
    slong d = solid->input.dimension;
    const uint32_t *vertex = solid->cut.item[simplex].vertex;
    LOCAL_VEC(fmpq, difference, d);
    fmpz *integer = p->room;
    for (slong i = 0; i < d; i++)
        fmpq_sub(difference + i, solid->input.coordinates + vertex[b] * (size_t)d + i,
                 solid->input.coordinates + vertex[a] * (size_t)d + i);
    _fmpq_vec_get_fmpz_vec_fmpz(integer, integer + d, difference, d);
    const point_map *map = p->map[SIDE_MOVING];
    for (slong i = 0; i < d; i++) {
        fmpz_poly_zero(&out->c[i]);
        if (side == SIDE_FIXED)
            fmpz_poly_set_fmpz(&out->c[i], integer + i);
        for (slong j = 0; j < d && side == SIDE_MOVING; j++) {
            fmpz_poly_scalar_mul_fmpz(p->product, &map->entry[i * (d + 1) + j], integer + j);
            fmpz_poly_add(&out->c[i], &out->c[i], p->product);
        }
    }
}
