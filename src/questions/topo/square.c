/* One sample in each gap between the curves on the sides of a square.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Within the square the curves through the point cut each quarter between the diagonals into
 * sectors. A sector is connected and misses the closed sweep's boundary, so it lies in the interior
 * or in the exterior; every smaller square meets the same sectors (proofs/topology.md C49).
 */
#include "questions/topo/topo.h"

#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include "base/context/scope.h"
#include "base/number/isolate.h"
#include "base/number/order.h"
#include "decide/scene/scene.h"
#include "decide/surfaces/surfaces.h"
#include "questions/topo/cover.h"
#include "questions/topo/eliminate.h"
#include "questions/topo/near.h"

typedef struct square_maker {
    topo_finding *out;
    graze_context *context;
    const graze_scene *scene;
    const plane_view *view;
    const fmpq *point;
    graze_topo_level level;
    near_curves *near;
    int axis, negative; /* the current side */
} square_maker;

/* Keep the square on whose border the witness lies. */
static void set_square(square_maker *m) {
    topo_finding *out = m->out;
    out->has_witness = 1;
    fmpq_one(&out->reach);
    fmpq_div_2exp(&out->reach, &out->reach, m->near->places);
    for (int k = 0; k < 2; k++)
        _fmpz_vec_set(out->along[k], m->view->along[k], m->view->dimension);
}

/* Classify the point of the current side at the coordinate `along`; a point that is out proves the
 * boundary. */
static graze_status sample_at(square_maker *m, const fmpq_t along) {
    int beyond = 0;
    LOCAL_VEC(fmpq, sample, 2);
    fmpq_set_si(sample + m->axis, m->negative ? -1 : 1, 1);
    fmpq_div_2exp(sample + m->axis, sample + m->axis, m->near->places);
    fmpq_set(sample + (1 - m->axis), along);
    for (int k = 0; k < 2; k++)
        fmpq_add(sample + k, sample + k, m->point + k);
    view_point(m->out->witness, m->view, sample);
    TRY(beyond_closed(&beyond, m->context, m->scene, m->out->witness));
    if (beyond) {
        finding_set(m->out, GRAZE_TOPO_BOUNDARY, m->level);
        set_square(m);
    }
    return GRAZE_OK;
}

/* Sample the gap between two numbers unless they are equal: a root may be at a corner, an end of
 * the side. */
static graze_status sample_gap(square_maker *m, algebraic *low, algebraic *high) {
    int sign = 0;
    TRY(algebraic_compare(&sign, m->context, low, high));
    if (sign == 0)
        return GRAZE_OK;
    LOCAL(fmpq, along);
    TRY(algebraic_between(along, m->context, low, high));
    return sample_at(m, along);
}

static graze_status sample_side(square_maker *m) {
    LOCAL(fmpz_poly, product);
    HELD(dyadic_interval, side);
    dyadic_interval_set_si(&side, -1, 1);
    side.exponent = m->near->places;
    HELD(algebraic_list, roots);
    HELD(algebraic, low);
    HELD(algebraic, high);
    algebraic_set_dyadic(&low, side.low, side.exponent);
    algebraic_set_dyadic(&high, side.high, side.exponent);
    near_side(product, m->near, m->axis, m->negative);
    TRY(algebraic_roots(&roots, m->context, product, &side));
    for (size_t k = 0; k <= roots.count && !m->out->has_witness; k++)
        TRY(sample_gap(m, k ? &roots.item[k - 1] : &low, k < roots.count ? &roots.item[k] : &high));
    return GRAZE_OK;
}

graze_status square_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                           const curve_list *curves, const plane_view *view, const fmpq *point,
                           graze_topo_level level) {
    int refused = 0;
    HELD(near_curves, near);
    square_maker m = {.out = out,
                      .context = context,
                      .scene = scene,
                      .view = view,
                      .point = point,
                      .level = level,
                      .near = &near};
    TRY(near_make(&near, &refused, context, curves, point));
    if (refused) {
        finding_undecided(
            out, "a curve passes nearer, or has more digits, than the limit `bits` allows");
        return GRAZE_OK;
    }
    for (int side = 0; side < 4 && !out->has_witness; side++) {
        m.axis = side / 2;
        m.negative = side % 2;
        TRY(sample_side(&m));
    }
    if (!out->has_witness && (view->dimension == 2 || level == GRAZE_LEVEL_SECTION))
        finding_set(out, GRAZE_TOPO_INTERIOR, level);
    return GRAZE_OK;
}
