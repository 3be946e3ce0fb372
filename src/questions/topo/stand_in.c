/* Points near a place are projected to the planes of facets that contain the place, until all signs
 * are right. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
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
    signed char *sign; /* signs of the place's distances from all planes of facets */
} place_finder;

static graze_status find_signs(place_finder *f, algebraic *time) {
    const plane_list *planes = f->place->planes;
    LOCAL(fmpz_poly, distance);
    for (size_t p = 0; p < planes->count; p++) {
        int sign = 0;
        const fmpz *form = planes->form + p * (size_t)(planes->dimension + 1);
        trajectory_pullback(distance, f->place->path, form);
        TRY(algebraic_sign_at(&sign, f->place->context, distance, time));
        f->sign[p] = (signed char)sign;
        TRY(context_poll(f->place->context));
    }
    return GRAZE_OK;
}

/* Project a point, d + 1 homogeneous integers, orthogonally to the planes that contain the place.
 */
static void project(fmpz *x, const place_finder *f) {
    const plane_list *planes = f->place->planes;
    int d = planes->dimension;
    LOCAL_VEC(fmpq, moved, (d + 1) * (d + 1));
    plane_stack to = {d, 0, moved + d + 1};
    for (int i = 0; i <= d; i++)
        fmpq_set_fmpz_frac(moved + i, x + i, x + d);
    for (size_t p = 0; p < planes->count; p++)
        if (f->sign[p] == 0)
            plane_stack_add(&to, moved, planes->form + p * (size_t)(d + 1));
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
