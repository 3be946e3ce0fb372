/* The three searches take turns in one band; the search whose enclosure is widest is next.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/judge/judge.h"

#include <math.h>
#include <stdlib.h>
#include "base/context/scope.h"
#include "decide/filter/filter.h"
#include "decide/scene/scene.h"
#include "input/solid/solid.h"
#include "questions/judge/cube.h"
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

/* The distance of the sweep's boundary to an empty mesh is infinite. */
static void judge_empty(suprema *s) {
    for (int k = 0; k < GRAZE_JUDGED_COUNT; k++)
        s->found[k].reached = 1;
    s->found[GRAZE_JUDGED_SWEEP].low = s->found[GRAZE_JUDGED_SWEEP].high = INFINITY;
}

static graze_status search_all(suprema *s) {
    static graze_status (*const step[GRAZE_JUDGED_COUNT])(suprema *) = {
        search_outside_step, search_inside_step, search_sweep_step};
    graze_status status = search_sweep_begin(s);
    if (!status)
        status = search_mesh_begin(s);
    for (int next = most_open(s); !status && next < GRAZE_JUDGED_COUNT && !suprema_is_over(s);
         next = most_open(s))
        status = step[next](s);
    return status;
}

static graze_status tell_times(suprema *s) {
    for (int k = 0; k < GRAZE_JUDGED_COUNT; k++)
        if (s->found[k].low > 0)
            TRY(suprema_time(&s->found[k].time, s, s->found[k].at));
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
    graze_status status = band_init(&out->space, context, scene);
    if (!status)
        status = filter_lay_bricks(&scene->filter, context);
    if (mesh->rule != GRAZE_MESH_NONE && mesh->cut.count && mesh->corners.at)
        out->space.mesh = mesh;
    if (!status && mesh->cut.count && !mesh->corners.at)
        status = context_fail(context, GRAZE_ELIMIT,
                              "a coordinate of the mesh is beyond 2^200; expected less");
    if (status)
        return status;
    if (mesh->cut.count)
        status = search_all(out);
    else
        judge_empty(out);
    if (!status)
        status = slabs_find(out);
    if (!status)
        status = volumes_find(out);
    return status || !mesh->cut.count ? status : tell_times(out);
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
