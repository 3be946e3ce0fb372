/* Forms composed with maps, on a plane. SPDX-License-Identifier: GPL-3.0-or-later */
#include <flint/fmpq_vec.h>
#include "base/context/scope.h"
#include "input/motion/motion.h"
#include "questions/topo/cover.h"

void pullback_form_init(pullback_form *f) {
    f->degree = 0;
    for (int i = 0; i < 3; i++)
        fmpz_poly_init(&f->linear[i]);
}

void pullback_form_clear(pullback_form *f) {
    for (int i = 0; i < 3; i++)
        fmpz_poly_clear(&f->linear[i]);
}

void pullback_of_form(pullback_form *f, const point_map *map, const fmpz *form,
                      const plane_view *view) {
    int d = map->dimension;
    LOCAL_VEC(fmpz, scale,
              d + 1); /* the origin's numerators over the common denominator scale[d] */
    LOCAL(fmpz, factor);
    LOCAL(fmpz_poly, column);
    _fmpq_vec_get_fmpz_vec_fmpz(scale, scale + d, view->origin, d);
    for (int i = 0; i < 3; i++)
        fmpz_poly_zero(&f->linear[i]);
    for (int j = 0; j <= d; j++) {
        fmpz_poly_zero(column);
        for (int row = 0; row < d; row++)
            fmpz_poly_scalar_addmul_fmpz(column, &map->entry[row * (d + 1) + j], form + row);
        if (j == d)
            fmpz_poly_scalar_addmul_fmpz(column, map->weight, form + d);
        fmpz_poly_scalar_addmul_fmpz(&f->linear[2], column, scale + j);
        for (int i = 0; i < 2 && j < d; i++) {
            fmpz_mul(factor, view->along[i] + j, scale + d);
            fmpz_poly_scalar_addmul_fmpz(&f->linear[i], column, factor);
        }
    }
}

void pullback_reduce(pullback_form *f, fmpz_poly_t common) {
    f->degree = 0;
    fmpz_poly_zero(common);
    for (int i = 0; i < 3; i++)
        fmpz_poly_gcd(common, common, &f->linear[i]);
    for (int i = 0; i < 3 && !fmpz_poly_is_zero(common); i++) {
        fmpz_poly_div(&f->linear[i], &f->linear[i], common);
        f->degree = FLINT_MAX(f->degree, fmpz_poly_degree(&f->linear[i]));
    }
}

void pullback_at(fmpz_mpoly_t out, const pullback_form *f, const fmpz_t time,
                 const fmpz_mpoly_ctx_t ring) {
    static const ulong power[3][RING_VARIABLES] = {{1, 0}, {0, 1}, {0, 0}};
    LOCAL(fmpz, value);
    fmpz_mpoly_zero(out, ring);
    for (int i = 0; i < 3; i++) {
        fmpz_poly_evaluate_fmpz(value, &f->linear[i], time);
        fmpz_mpoly_set_coeff_fmpz_ui(out, value, power[i], ring);
    }
}
