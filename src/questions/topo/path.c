/* The first part of a path, which meets no curve of its plane.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The path has the coordinates x = s^m, y = s^(m + 1) p / q. Inserted into a curve's polynomial
 * they give a polynomial in s; below its first positive root the path does not meet the curve.
 */
#include "questions/topo/topo.h"

#include <flint/fmpz_vec.h>
#include "base/context/scope.h"
#include "decide/bounds/bounds.h"
#include "decide/scene/scene.h"
#include "questions/topo/cover.h"
#include "questions/topo/eliminate.h"
#include "questions/topo/near.h"

/* A curve's polynomial along the path, as a polynomial in s, times a power of q. */
static void curve_on_path(fmpz_poly_t out, const fmpz_mpoly_t curve, const topo_finding *f,
                          const fmpz_mpoly_ctx_t ring) {
    slong most = fmpz_mpoly_degree_si(curve, RING_Y, ring);
    LOCAL_VEC(fmpz, c, 3);
    fmpz *power = c + 1, *sum = c + 2;
    fmpz_poly_zero(out);
    for (slong k = 0; k < fmpz_mpoly_length(curve, ring); k++) {
        ulong e[RING_VARIABLES];
        fmpz_mpoly_get_term_exp_ui(e, curve, k, ring);
        fmpz_mpoly_get_term_coeff_fmpz(c, curve, k, ring);
        fmpz_pow_ui(power, fmpq_numref(&f->lift), e[RING_Y]);
        fmpz_mul(c, c, power);
        fmpz_pow_ui(power, fmpq_denref(&f->lift), (ulong)most - e[RING_Y]);
        slong at = f->order * (slong)e[RING_X] + (f->order + 1) * (slong)e[RING_Y];
        fmpz_poly_get_coeff_fmpz(sum, out, at);
        fmpz_addmul(sum, c, power);
        fmpz_poly_set_coeff_fmpz(out, at, sum);
    }
}

/* Take the path's place at s = 2^-places as the witness, if it is out. */
static graze_status try_path(topo_finding *out, graze_context *context, const graze_scene *scene,
                             const plane_view *view, ulong places) {
    int beyond = 0;
    LOCAL_VEC(fmpq, xy, 2);
    fmpq_one(xy);
    fmpq_div_2exp(xy, xy, places * (ulong)out->order);
    fmpq_div_2exp(xy + 1, &out->lift, places * (ulong)(out->order + 1));
    view_point(out->witness, view, xy);
    TRY(beyond_closed(&beyond, context, scene, out->witness));
    if (beyond) {
        finding_set(out, GRAZE_TOPO_BOUNDARY, GRAZE_LEVEL_LEADING_TERMS);
        out->has_witness = 1;
        fmpq_one(&out->reach);
        fmpq_div_2exp(&out->reach, &out->reach, places);
    }
    return GRAZE_OK;
}

graze_status path_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                         const curve_list *curves, const plane_view *view) {
    ulong places = 0;
    LOCAL(fmpz_poly, p);
    for (size_t k = 0; k < curves->count; k++) {
        TRY(context_poll(context));
        curve_on_path(p, &curves->item[k], out, curves->ring);
        if (fmpz_poly_is_zero(p))
            return GRAZE_OK;
        places_below_roots(&places, p);
        if (places > context->limits[GRAZE_LIMIT_BITS])
            return GRAZE_OK;
    }
    return try_path(out, context, scene, view, places);
}
