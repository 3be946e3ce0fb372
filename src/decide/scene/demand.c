/* A point asks for the roots of functions made of those of one piece, so the largest piece bounds
 * it, and pieces are not counted. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/scene/scene.h"

enum { WORK_A_UNIT = 256 };

double demand_of_roots(const fmpz_poly_t p) {
    return (double)fmpz_poly_length(p) * (double)polynomial_work(p) / WORK_A_UNIT;
}

graze_status demand_check(graze_context *context, const graze_scene *scene, double points,
                          const char *what) {
    const graze_motion *motion = scene->motion;
    int entries = motion->dimension * (motion->dimension + 1);
    double most = 0;
    for (size_t k = 0; k < motion->piece_count; k++) {
        const point_map *map = motion_tracing(motion->piece + k, scene->options.operation);
        double own = demand_of_roots(map->weight);
        for (int e = 0; e < entries; e++)
            own += demand_of_roots(map->entry + e);
        most = own > most ? own : most;
    }
    return points * most > (double)context->limits[GRAZE_LIMIT_WORK]
               ? context_limit(context, GRAZE_LIMIT_WORK, what)
               : GRAZE_OK;
}
