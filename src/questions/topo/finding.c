/* Results and the names of their levels; a hint by places at a few distances.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/topo/eliminate.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "decide/verdict/verdict.h"

NAMES_OF(graze_topo_name, graze_topo, {"none", "interior", "boundary", "exterior", "undecided"})

const char *graze_regular_name(graze_topo topo) {
    return topo == GRAZE_TOPO_INTERIOR || topo == GRAZE_TOPO_BOUNDARY ? "yes"
           : topo == GRAZE_TOPO_EXTERIOR                              ? "no"
                                                                      : graze_topo_name(topo);
}

NAMES_OF(graze_topo_level_name, graze_topo_level,
         {"none", "word", "first_order", "curves", "closed_cones", "edges", "section",
          "leading_terms"})

void finding_init(topo_finding *f) {
    *f = (topo_finding){
        .reason = "", .witness = {{0, 1}, {0, 1}, {0, 1}}, .reach = {0, 1}, .lift = {0, 1}};
}

void finding_clear(topo_finding *f) {
    fmpq_clear(&f->reach);
    fmpq_clear(&f->lift);
    for (int k = 0; k < 3; k++)
        fmpq_clear(f->witness + k);
    _fmpz_vec_zero(f->direction, 3);
    _fmpz_vec_zero(f->along[0], 3);
    _fmpz_vec_zero(f->along[1], 3);
    _fmpz_vec_zero(f->open, 3);
    _fmpz_vec_zero(f->across, 3);
}

topo_witness finding_witness(const topo_finding *f) {
    return f->level == GRAZE_LEVEL_FIRST_ORDER     ? WITNESS_RAY
           : f->level == GRAZE_LEVEL_LEADING_TERMS ? WITNESS_PATH
                                                   : WITNESS_SQUARE;
}

void finding_set(topo_finding *f, graze_topo position, graze_topo_level level) {
    f->position = position;
    f->level = level;
}

void finding_undecided(topo_finding *f, const char *reason) {
    finding_set(f, GRAZE_TOPO_UNDECIDED, GRAZE_LEVEL_NONE);
    f->reason = reason;
}

graze_status beyond_closed(int *out, graze_context *context, const graze_scene *scene,
                           const fmpq *point) {
    graze_verdict verdict;
    graze_pmc wanted = scene->options.operation == GRAZE_UNSWEEP ? GRAZE_IN : GRAZE_OUT;
    graze_status status =
        classify_verdict(&verdict, context, scene, (query_point){.rational = point});
    *out = !status && verdict.pmc == wanted;
    return status;
}

typedef struct hint_maker {
    graze_context *context;
    const graze_scene *scene;
    const fmpq *point;
    fmpq *out;
    slong exponent; /* the solid's width is about 2^exponent */
    int found;
} hint_maker;

/* Is the place P + r v + r^2 w / 8 out, with r about 2^-places times the solid's width, for v and w
 * scaled to a length of about 1? */
static graze_status try_place(hint_maker *m, const fmpz *v, const fmpz *w, ulong places) {
    LOCAL_VEC(fmpq, step, 2);
    fmpq *bend = step + 1;
    slong down = (slong)places - m->exponent;
    for (int k = 0; k < 3; k++) {
        fmpq_set_fmpz(step, v + k);
        fmpq_set_fmpz(bend, w + k);
        rational_shift(step, -down - FLINT_ABS(_fmpz_vec_max_bits(v, 3)));
        rational_shift(bend, -2 * down - FLINT_ABS(_fmpz_vec_max_bits(w, 3)) - 3);
        fmpq_add(step, step, bend);
        fmpq_add(m->out + k, m->point + k, step);
    }
    return beyond_closed(&m->found, m->context, m->scene, m->out);
}

/* Try a direction, straight and bent to both sides of the plane with the normal, if that is not 0.
 */
static graze_status look_along_both(hint_maker *m, const fmpz *v, const fmpz *normal,
                                    ulong places) {
    LOCAL_VEC(fmpz, bend, 3);
    for (slong sign = 0; sign < 3 && !m->found; sign++) {
        _fmpz_vec_scalar_mul_si(bend, normal, 3, sign == 2 ? -1 : sign);
        if (sign == 0 || !_fmpz_vec_is_zero(normal, 3))
            TRY(try_place(m, v, bend, places));
    }
    return GRAZE_OK;
}

/* Try the open direction, the 26 directions with entries -1, 0, 1 and, if there is a plane, the
 * projections of these to the plane. */
static graze_status look_about_point(hint_maker *m, const topo_finding *topo, ulong places) {
    LOCAL_VEC(fmpz, v, 12);
    fmpz *normal = v + 3, *in_plane = v + 6, *other = v + 9;
    if (topo->has_across)
        _fmpz_vec_set(normal, topo->across, 3);
    if (topo->has_open)
        TRY(look_along_both(m, topo->open, normal, places));
    for (slong k = 0; k < 27 && !m->found; k++) {
        fmpz_set_si(v, k % 3 - 1);
        fmpz_set_si(v + 1, k / 3 % 3 - 1);
        fmpz_set_si(v + 2, k / 9 - 1);
        integers_cross(other, normal, v);
        integers_cross(in_plane, normal, other);
        if (!_fmpz_vec_is_zero(v, 3))
            TRY(look_along_both(m, v, normal, places));
        if (!m->found && !_fmpz_vec_is_zero(in_plane, 3))
            TRY(look_along_both(m, in_plane, normal, places));
    }
    return GRAZE_OK;
}

graze_status hint_find(int *found, fmpq *out, ulong *places, graze_context *context,
                       const graze_scene *scene, const fmpq *point, const topo_finding *topo) {
    static const ulong scale[] = {100, 60, 40, 24, 16, 10, 6, 3};
    hint_maker m = {.context = context, .scene = scene, .point = point, .out = out};
    int exponent = 0;
    double width = box_extent(&scene->solid->boxes.node[0].box);
    (void)frexp(isfinite(width) ? width : 1, &exponent);
    m.exponent = exponent;
    for (size_t k = 0; k < sizeof scale / sizeof *scale && !m.found; k++) {
        *places = scale[k];
        TRY(look_about_point(&m, topo, *places));
    }
    *found = m.found;
    return GRAZE_OK;
}
