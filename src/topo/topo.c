/* The levels in their order. SPDX-License-Identifier: GPL-3.0-or-later */
#include "topo/topo.h"

#include <stdlib.h>
#include "topo/curves.h"
#include "topo/square.h"

/* What all points of a scene share, made once. */
typedef struct scene_curves {
    int refused;
    curve_list list;
} scene_curves;

static void scene_curves_free(void *value) {
    scene_curves *c = value;
    curves_clear(&c->list);
    free(c);
}

static graze_status make_scene_curves(scene_curves **out, graze_context *context,
                                      const graze_scene *scene) {
    scene_curves *made = malloc(sizeof *made);
    if (!made)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for the curves of a sweep");
    curves_init(&made->list);
    graze_status status = curves_of_scene(&made->list, &made->refused, context, scene);
    if (status)
        scene_curves_free(made);
    else
        *out = made;
    return status;
}

/* The curves of a scene, kept with it. */
static graze_status curves_for(const scene_curves **out, graze_context *context,
                               const graze_scene *scene) {
    scene_memo *memo = scene->memo;
    scene_curves *made = NULL;
    graze_status status = GRAZE_OK;
    pthread_mutex_lock(&memo->lock);
    if (!memo->value && (status = make_scene_curves(&made, context, scene)) == GRAZE_OK) {
        memo->value = made;
        memo->free = scene_curves_free;
    }
    *out = memo->value;
    pthread_mutex_unlock(&memo->lock);
    return status;
}

static graze_status decide_in_plane(topo_finding *out, graze_context *context,
                                    const graze_scene *scene, const fmpq *point) {
    const scene_curves *curves = NULL;
    graze_status status = curves_for(&curves, context, scene);
    if (status)
        return status;
    if (!curves->refused)
        return square_decide(out, context, scene, &curves->list, point);
    finding_undecided(out, "the scene has more curves, or curves of a higher degree, than are "
                           "looked at");
    return GRAZE_OK;
}

graze_status topo_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                         const fmpq *point, const graze_trace *trace) {
    graze_pmc pmc = trace->verdict.pmc;
    int unsweep = scene->options.operation == GRAZE_UNSWEEP;
    if (pmc != GRAZE_ON || unsweep)
        finding_set(out,
                    pmc == GRAZE_IN    ? GRAZE_TOPO_INTERIOR
                    : pmc == GRAZE_OUT ? GRAZE_TOPO_EXTERIOR
                                       : GRAZE_TOPO_BOUNDARY,
                    GRAZE_LEVEL_WORD);
    else if (scene->motion->dimension == 2)
        return decide_in_plane(out, context, scene, point);
    else
        finding_undecided(out, "no level decides it in space");
    return GRAZE_OK;
}
