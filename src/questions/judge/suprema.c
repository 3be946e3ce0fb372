/* The three searches take turns in one band; the search whose enclosure is widest is next.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/judge/cube.h"

#include <math.h>
#include "base/context/scope.h"
#include "questions/judge/open_search.h"

/* The distance with the widest enclosure; GRAZE_JUDGED_COUNT if no search can go on. */
static int most_open(const suprema *s) {
    int most = GRAZE_JUDGED_COUNT;
    double open = 0;
    for (int k = 0; k < GRAZE_JUDGED_COUNT; k++) {
        const supremum *f = &s->found[k];
        if (f->reached || f->stuck || f->high - f->low <= open)
            continue;
        open = f->high - f->low;
        most = k;
    }
    return most;
}

static graze_status search_all(suprema *s) {
    static graze_status (*const step[GRAZE_JUDGED_COUNT])(suprema *) = {
        search_outside_step, search_inside_step, search_sweep_step};
    TRY(search_sweep_begin(s));
    TRY(search_mesh_begin(s));
    for (int next; (next = most_open(s)) < GRAZE_JUDGED_COUNT && !suprema_is_over(s);)
        TRY(step[next](s));
    return GRAZE_OK;
}

graze_status suprema_find(suprema *out, graze_context *context, const graze_scene *scene,
                          const judged_mesh *mesh, double within, size_t budget, int threads) {
    *out = (suprema){.context = context,
                     .scene = scene,
                     .mesh = mesh,
                     .within = within,
                     .budget = budget,
                     .threads = threads};
    for (int k = 0; k < 2 * VOLUME_COUNT; k++)
        fmpq_init(out->volume + k);
    TRY(band_init(&out->space, context, scene));
    TRY(filter_lay_bricks(&scene->filter, context));
    if (mesh->rule != GRAZE_MESH_NONE && mesh->cut.count && mesh->corners.at)
        out->space.mesh = mesh;
    if (mesh->cut.count && !mesh->corners.at)
        return context_fail(context, GRAZE_ELIMIT,
                            "a coordinate of the mesh is beyond 2^200; expected less");
    if (mesh->cut.count) {
        TRY(search_all(out));
    } else { /* the distance of the sweep's boundary to an empty mesh is infinite */
        for (int k = 0; k < GRAZE_JUDGED_COUNT; k++)
            out->found[k].reached = 1;
        out->found[GRAZE_JUDGED_SWEEP].low = out->found[GRAZE_JUDGED_SWEEP].high = INFINITY;
    }
    TRY(slabs_find(out));
    TRY(volumes_find(out));
    for (int k = 0; k < GRAZE_JUDGED_COUNT && mesh->cut.count; k++)
        if (out->found[k].low > 0)
            TRY(suprema_time(&out->found[k].time, out, out->found[k].at));
    return GRAZE_OK;
}

void suprema_clear(suprema *s) {
    for (int k = 0; k < 2 * VOLUME_COUNT; k++)
        fmpq_clear(s->volume + k);
    band_clear(&s->space);
    priority_clear(&s->cubes);
    priority_clear(&s->outer);
    priority_clear(&s->inner);
    free(s->part);
    free(s->slab);
}
