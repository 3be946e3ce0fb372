/* A few planes through a point of space, each looked at like the plane itself.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The planes lie askew, so that facets seldom come to lie in one.
 */
#include "topo/slices.h"

#include <flint/fmpz_vec.h>
#include "topo/curves.h"
#include "topo/square.h"

enum { SLICES = 3 };

static const slong askew[SLICES][2][3] = {
    {{3, 1, 2}, {-1, 4, 1}}, {{2, -5, 1}, {1, 1, 4}}, {{1, 2, -7}, {5, -2, 3}}};

/* Look at the plane through the point along two directions, 6 integers. */
static graze_status look_in_plane(topo_finding *out, graze_context *context,
                                  const graze_scene *scene, const plane_list *planes,
                                  const fmpq *point, const fmpz *along) {
    plane_view view;
    curve_list curves;
    const char *refused = NULL;
    fmpq origin[2] = {{0, 1}, {0, 1}};
    view_init_through(&view, point, along, along + 3);
    curves_init(&curves);
    graze_status status = curves_of_scene(&curves, &refused, context, scene, planes, &view);
    if (!status && !refused)
        status = square_decide(out, context, scene, &curves, &view, origin);
    curves_clear(&curves);
    view_clear(&view);
    return status;
}

static int are_parallel(const fmpz *a, const fmpz *b) {
    int parallel = 1;
    fmpz_t det;
    fmpz_init(det);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        fmpz_mul(det, a + i, b + j);
        fmpz_submul(det, a + j, b + i);
        parallel = parallel && fmpz_is_zero(det);
    }
    fmpz_clear(det);
    return parallel;
}

graze_status slices_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                           const plane_list *planes, const fmpq *point) {
    const char *reason = out->reason;
    graze_status status = GRAZE_OK;
    fmpz *along = _fmpz_vec_init(6);
    for (int k = 0; k < SLICES && !status && !out->has_witness; k++) {
        for (int i = 0; i < 6; i++)
            fmpz_set_si(along + i, askew[k][i / 3][i % 3]);
        if (out->has_open)
            _fmpz_vec_set(along, out->open, 3);
        if (are_parallel(along, along + 3))
            continue;
        status = look_in_plane(out, context, scene, planes, point, along);
    }
    if (!status && !out->has_witness)
        finding_undecided(out, reason);
    else if (!status)
        out->reason = "";
    _fmpz_vec_clear(along, 6);
    return status;
}
