/* The common kernel of all normals about the point, as functions of time: of all their
 * coefficients. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/topo/invariant.h"

#include <flint/fmpz_vec.h>
#include "questions/topo/directions.h"
#include "questions/topo/signs.h"

/* Independent vectors: their number, or 3 for all of space. */
typedef struct normal_span {
    int rank;
    fmpz *basis; /* two of 3, and their product */
} normal_span;

static void span_add(normal_span *s, const fmpz *v) {
    fmpz *cross = s->basis + 6;
    fmpz_t volume;
    fmpz_init(volume);
    if (s->rank == 0 && !_fmpz_vec_is_zero(v, 3)) {
        _fmpz_vec_set(s->basis, v, 3);
        s->rank = 1;
    } else if (s->rank == 1 && !directions_parallel(s->basis, v)) {
        _fmpz_vec_set(s->basis + 3, v, 3);
        directions_cross(cross, s->basis, v);
        s->rank = 2;
    } else if (s->rank == 2) {
        _fmpz_vec_dot(volume, cross, v, 3);
        s->rank += !fmpz_is_zero(volume);
    }
    fmpz_clear(volume);
}

/* A normal's coefficients at every power of time. */
static void span_add_normal(normal_span *s, const point_map *map, const fmpz *normal) {
    static const fmpz axis[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    slong length = 0;
    fmpz *v = _fmpz_vec_init(3);
    fmpz_poly_struct entry[3];
    for (int i = 0; i < 3; i++) {
        fmpz_poly_init(entry + i);
        signs_pull_back(entry + i, map, normal, axis[i]);
        length = FLINT_MAX(length, fmpz_poly_length(entry + i));
    }
    for (slong k = 0; k < length; k++) {
        for (int i = 0; i < 3; i++)
            fmpz_poly_get_coeff_fmpz(v + i, entry + i, k);
        span_add(s, v);
    }
    for (int i = 0; i < 3; i++)
        fmpz_poly_clear(entry + i);
    _fmpz_vec_clear(v, 3);
}

int invariant_direction(fmpz *out, const germ_list *list) {
    normal_span s = {0, _fmpz_vec_init(9)};
    for (size_t k = 0; k < list->count && s.rank < 3; k++) {
        const germ *g = &list->item[k];
        for (size_t j = 0; j < g->cone.count && s.rank < 3; j++)
            span_add_normal(&s, g->map, g->cone.normal + 3 * j);
    }
    if (s.rank == 1) { /* a direction across it: any other normal may be added */
        fmpz *axis = _fmpz_vec_init(3);
        fmpz_one(axis + (fmpz_is_zero(s.basis + 1) && fmpz_is_zero(s.basis + 2)));
        span_add(&s, axis);
        _fmpz_vec_clear(axis, 3);
    }
    int found = s.rank == 2;
    if (found)
        _fmpz_vec_set(out, s.basis + 6, 3);
    _fmpz_vec_clear(s.basis, 9);
    return found;
}
