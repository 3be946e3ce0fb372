/* Points near a place are projected to the planes of facets that contain the place, until all signs
 * are right. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpq_mat.h>
#include <flint/fmpq_vec.h>
#include <flint/fmpz_mat.h>
#include <flint/fmpz_vec.h>
#include <stdlib.h>
#include "base/context/scope.h"
#include "base/number/refine.h"
#include "base/number/sign.h"
#include "decide/trace/trace.h"
#include "input/solid/solid.h"
#include "questions/topo/near.h"

/* The first attempt narrows the time to an interval of width about 2^-FIRST_PLACES; each further
 * attempt doubles the exponent. */
enum { FIRST_PLACES = 40, ATTEMPTS = 10 };

/* A rational time near an algebraic one, from an interval of width about 2^-places. */
static graze_status time_near(fmpq_t out, graze_context *context, algebraic *time, ulong places) {
    ulong gain = FIRST_GAIN;
    LOCAL(fmpq, high);
    for (int step = 0; !algebraic_is_rational(time) && time->where.exponent < places; step++)
        TRY(algebraic_narrow(context, time, step, &gain));
    algebraic_bounds(out, high, time);
    fmpq_add(out, out, high);
    fmpq_div_2exp(out, out, 1);
    return GRAZE_OK;
}

/* State of the search for a point. */
typedef struct place_finder {
    const germ_place *place;
    signed char *sign;    /* signs of the place's distances from all planes of facets */
    const fmpz *basis[3]; /* forms of independent planes that contain the place */
    int rank;
} place_finder;

/* Keep a plane, which contains the place, if its normal is independent of the normals kept. */
static void keep_independent(place_finder *f, const fmpz *form) {
    int d = f->place->map->dimension;
    if (f->rank == d)
        return;
    f->basis[f->rank] = form;
    LOCAL(fmpz_mat, normals, f->rank + 1, d);
    for (int k = 0; k <= f->rank; k++)
        for (int i = 0; i < d; i++)
            fmpz_set(fmpz_mat_entry(normals, k, i), f->basis[k] + i);
    f->rank = (int)fmpz_mat_rank(normals);
}

static graze_status find_signs(place_finder *f, algebraic *time) {
    const plane_list *planes = f->place->planes;
    LOCAL(fmpz_poly, distance);
    for (size_t p = 0; p < planes->count; p++) {
        int sign = 0;
        const fmpz *form = planes->form + p * (size_t)(planes->dimension + 1);
        trajectory_pullback(distance, f->place->path, form);
        TRY(algebraic_sign_at(&sign, f->place->context, distance, time));
        f->sign[p] = (signed char)sign;
        if (sign == 0)
            keep_independent(f, form);
        TRY(context_poll(f->place->context));
    }
    return GRAZE_OK;
}

/* Project a point, d + 1 homogeneous integers, orthogonally to the intersection of the basis's
 * planes. */
static void project(fmpz *x, const place_finder *f) {
    int d = f->place->map->dimension;
    LOCAL_VEC(fmpq, moved, d);
    LOCAL(fmpz, value);
    LOCAL(fmpq_mat, gram, f->rank, f->rank);
    LOCAL(fmpq_mat, rest, f->rank, 1);
    for (int i = 0; i < f->rank; i++) {
        for (int j = 0; j < f->rank; j++) {
            _fmpz_vec_dot(value, f->basis[i], f->basis[j], d);
            fmpq_set_fmpz(fmpq_mat_entry(gram, i, j), value);
        }
        _fmpz_vec_dot(value, f->basis[i], x, d + 1);
        fmpz_neg(value, value);
        fmpq_set_fmpz_frac(fmpq_mat_entry(rest, i, 0), value, x + d);
    }
    (void)fmpq_mat_solve(rest, gram, rest); /* independent normals: solvable */
    for (int i = 0; i < d; i++) {
        fmpq_set_fmpz_frac(moved + i, x + i, x + d);
        for (int k = 0; k < f->rank; k++) {
            LOCAL(fmpq, way);
            fmpq_mul_fmpz(way, fmpq_mat_entry(rest, k, 0), f->basis[k] + i);
            fmpq_add(moved + i, moved + i, way);
        }
    }
    _fmpq_vec_get_fmpz_vec_fmpz(x, x + d, moved, d);
}

static int has_signs(const fmpz *x, const place_finder *f) {
    const plane_list *planes = f->place->planes;
    for (size_t p = 0; p < planes->count; p++)
        if (form_sign(planes->form + p * (size_t)(planes->dimension + 1), x, planes->dimension) !=
            f->sign[p])
            return 0;
    return 1;
}

graze_status place_find(int *found, fmpz *x, fmpq_t near, const germ_place *place,
                        algebraic *time) {
    FREED(signed char, sign, malloc(place->planes->count + 1));
    place_finder f = {.place = place, .sign = sign};
    if (!sign)
        return context_fail(place->context, GRAZE_ESYSTEM, "out of memory for a contact");
    TRY(find_signs(&f, time));
    *found = 0;
    for (int k = 0; k < ATTEMPTS && !*found; k++) {
        TRY(time_near(near, place->context, time, (ulong)FIRST_PLACES << k));
        trajectory_at(x, place->path, near);
        project(x, &f);
        *found = has_signs(x, &f);
    }
    return GRAZE_OK;
}
