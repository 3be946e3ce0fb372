/* The public functions of solids that do not move.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include "graze/solid.h"

graze_status graze_scene_at_rest(graze_scene **out, graze_context *context,
                                 const graze_solid *solid) {
    PUBLIC_OUT(out, context, solid);
    CREATE(out, made, free, scene_at_rest(made, context, solid));
}

/* Classify points given as rationals or, if `rationals` is NULL, as doubles. */
static graze_status classify_at_rest(graze_pmc *out, graze_context *context,
                                     const graze_solid *solid, graze_rationals rationals,
                                     const double *doubles, size_t n) {
    graze_scene *scene = NULL;
    memset(out, 0, n * sizeof *out);
    FREED(graze_verdict, verdict, calloc(n, sizeof *verdict));
    if (!verdict)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for %zu points", n);
    TRY(graze_scene_at_rest(&scene, context, solid));
    graze_status status =
        api_classify(verdict, context, scene, rationals, doubles, n, GRAZE_COLUMNS_PMC);
    for (size_t k = 0; k < n; k++)
        out[k] = verdict[k].pmc;
    graze_scene_destroy(scene);
    return status;
}

graze_status graze_solid_classify(graze_pmc *out, graze_context *context, const graze_solid *solid,
                                  graze_rationals points, size_t n) {
    GIVEN(context, solid);
    REFUSED(n && (!out || !points), "out and points must not be NULL with n > 0");
    return n ? classify_at_rest(out, context, solid, points, NULL, n) : GRAZE_OK;
}

graze_status graze_solid_classify_doubles(graze_pmc *out, graze_context *context,
                                          const graze_solid *solid, const double *points,
                                          size_t n) {
    GIVEN(context, solid);
    REFUSED(n && (!out || !points), "out and points must not be NULL with n > 0");
    return n ? classify_at_rest(out, context, solid, NULL, points, n) : GRAZE_OK;
}
