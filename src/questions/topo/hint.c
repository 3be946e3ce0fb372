/* Tries places at a few distances. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/topo/hint.h"

#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include <math.h>
#include "questions/topo/beyond.h"
#include "questions/topo/directions.h"

typedef struct hint_maker {
    graze_context *context;
    const graze_scene *scene;
    const fmpq *point;
    fmpq *out;
    slong exponent; /* the solid's width is about 2^exponent */
    int found;
} hint_maker;

static void divide_2exp(fmpq_t x, slong places) {
    if (places < 0)
        fmpq_mul_2exp(x, x, (ulong)-places);
    else
        fmpq_div_2exp(x, x, (ulong)places);
}

/* Try the place P + 2^-places (v + 2^-places w), for vectors about as long as the solid's width: is
 * it out? */
static graze_status try_place(hint_maker *m, const fmpz *v, const fmpz *w, ulong places) {
    fmpq *step = _fmpq_vec_init(2), *bend = step + 1;
    slong down = (slong)places - m->exponent;
    for (int k = 0; k < 3; k++) {
        fmpq_set_fmpz(step, v + k);
        fmpq_set_fmpz(bend, w + k);
        divide_2exp(step, down + FLINT_ABS(_fmpz_vec_max_bits(v, 3)));
        divide_2exp(bend, 2 * down + FLINT_ABS(_fmpz_vec_max_bits(w, 3)) + 3);
        fmpq_add(step, step, bend);
        fmpq_add(m->out + k, m->point + k, step);
    }
    graze_status status = beyond_closed(&m->found, m->context, m->scene, m->out);
    _fmpq_vec_clear(step, 2);
    return status;
}

/* Try a direction, straight and bent to both sides of the plane. */
static graze_status look_along_both(hint_maker *m, const fmpz *v, const fmpz *normal,
                                    ulong places) {
    graze_status status = GRAZE_OK;
    fmpz *bend = _fmpz_vec_init(3);
    for (slong sign = 0; sign < 3 && !status && !m->found; sign++) {
        _fmpz_vec_scalar_mul_si(bend, normal, 3, sign == 2 ? -1 : sign);
        if (sign == 0 || !_fmpz_vec_is_zero(normal, 3))
            status = try_place(m, v, bend, places);
    }
    _fmpz_vec_clear(bend, 3);
    return status;
}

/* Try the 26 directions with entries -1, 0, 1 and, if there is a plane, their projections to it. */
static graze_status look_about_point(hint_maker *m, const topo_finding *topo, ulong places) {
    graze_status status = GRAZE_OK;
    fmpz *v = _fmpz_vec_init(12), *normal = v + 3, *in_plane = v + 6, *other = v + 9;
    if (topo->has_across)
        _fmpz_vec_set(normal, topo->across, 3);
    if (topo->has_open)
        status = look_along_both(m, topo->open, normal, places);
    for (slong k = 0; k < 27 && !status && !m->found; k++) {
        fmpz_set_si(v, k % 3 - 1);
        fmpz_set_si(v + 1, k / 3 % 3 - 1);
        fmpz_set_si(v + 2, k / 9 - 1);
        directions_cross(other, normal, v);
        directions_cross(in_plane, normal, other);
        if (!_fmpz_vec_is_zero(v, 3))
            status = look_along_both(m, v, normal, places);
        if (!status && !m->found && !_fmpz_vec_is_zero(in_plane, 3))
            status = look_along_both(m, in_plane, normal, places);
    }
    _fmpz_vec_clear(v, 12);
    return status;
}

graze_status hint_find(int *found, fmpq *out, ulong *places, graze_context *context,
                       const graze_scene *scene, const fmpq *point, const topo_finding *topo) {
    static const ulong scale[] = {100, 60, 40, 24, 16, 10, 6, 3};
    hint_maker m = {.context = context, .scene = scene, .point = point, .out = out};
    int exponent = 0;
    double width = box_extent(&scene->solid->boxes.node[0].box);
    (void)frexp(isfinite(width) ? width : 1, &exponent);
    m.exponent = exponent;
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < sizeof scale / sizeof *scale && !status && !m.found; k++) {
        *places = scale[k];
        status = look_about_point(&m, topo, *places);
    }
    *found = m.found;
    return status;
}
