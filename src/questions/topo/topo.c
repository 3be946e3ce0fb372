/* The levels in their order. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/topo/eliminate.h"

#include "base/context/scope.h"

/* Data shared by all points of a scene: the planes of its facets and, once needed, its curves. */
typedef struct scene_shares {
    plane_list planes;
    int has_curves;
    const char *refused;
    ulong limit; /* limit `curve` with which the curves were made or refused */
    curve_list curves;
} scene_shares;

static void free_shares(void *value) {
    scene_shares *s = value;
    planes_clear(&s->planes);
    curve_list_clear(&s->curves);
    free(s);
}

static graze_status make_shares(scene_memo *memo, graze_context *context,
                                const graze_scene *scene) {
    scene_shares *made = calloc(1, sizeof *made);
    if (!made || planes_find(&made->planes, NULL, scene->solid, NULL, scene->solid->cut.count)) {
        free(made);
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for the planes of a solid");
    }
    curve_list_init(&made->curves);
    memo->value = made;
    memo->free = free_shares;
    return GRAZE_OK;
}

/* Make the curves. After a failure the next point tries again; after a refusal, it does so only
 * with a higher limit. */
static graze_status make_curves(scene_shares *s, graze_context *context, const graze_scene *scene) {
    HELD(plane_view, view);
    graze_status status =
        curves_of_scene(&s->curves, &s->refused, context, scene, &s->planes, &view);
    s->has_curves = !status && !s->refused;
    s->limit = context->limits[GRAZE_LIMIT_CURVE];
    if (!s->has_curves) {
        curve_list_clear(&s->curves);
        curve_list_init(&s->curves);
    }
    return status;
}

/* Give the shared data, with or without curves. Planes, and curves once made, do not change until
 * the scene ends. */
static graze_status shares_of(const scene_shares **out, graze_context *context,
                              const graze_scene *scene, int with_curves) {
    scene_memo *memo = scene->memo;
    graze_status status = GRAZE_OK;
    pthread_mutex_lock(&memo->lock);
    if (!memo->value)
        status = make_shares(memo, context, scene);
    scene_shares *s = memo->value;
    if (!status && with_curves && !s->has_curves &&
        (!s->refused || s->limit < context->limits[GRAZE_LIMIT_CURVE]))
        status = make_curves(s, context, scene);
    *out = s;
    pthread_mutex_unlock(&memo->lock);
    return status;
}

graze_status topo_planes(const plane_list **out, graze_context *context, const graze_scene *scene) {
    const scene_shares *s = NULL;
    TRY(shares_of(&s, context, scene, 0));
    *out = &s->planes;
    return GRAZE_OK;
}

graze_status topo_by_curves(topo_finding *out, graze_context *context, const graze_scene *scene,
                            const fmpq *point) {
    const scene_shares *s = NULL;
    TRY(shares_of(&s, context, scene, 1));
    if (s->refused) {
        finding_undecided(out, s->refused);
        return GRAZE_OK;
    }
    HELD(plane_view, view);
    return square_decide(out, context, scene, &s->curves, &view, point, GRAZE_LEVEL_CURVES);
}

/* Decide an `on` point relative to the closed sweep; for an unsweep, relative to the sweep of the
 * solid's complement. */
static graze_status decide_on(topo_finding *out, graze_context *context, const graze_scene *scene,
                              const fmpq *point) {
    const plane_list *planes;
    TRY(topo_planes(&planes, context, scene));
    TRY(leading_decide(out, context, scene, planes, point));
    if (out->position != GRAZE_TOPO_UNDECIDED)
        return GRAZE_OK;
    if (scene->motion->dimension == 3)
        return slices_decide(out, context, scene, planes, point);
    finding_set(out, GRAZE_TOPO_NONE, GRAZE_LEVEL_NONE);
    out->reason = "";
    return topo_by_curves(out, context, scene, point);
}

/* Decide a point by the verdict of its word; returns 0 for an `on` point, which the word does not
 * decide. */
static int decide_by_word(topo_finding *out, graze_pmc pmc) {
    if (pmc == GRAZE_ON)
        return 0;
    finding_set(out, pmc == GRAZE_IN ? GRAZE_TOPO_INTERIOR : GRAZE_TOPO_EXTERIOR, GRAZE_LEVEL_WORD);
    return 1;
}

graze_status topo_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                         const fmpq *point, const graze_trace *trace) {
    if (decide_by_word(out, trace->verdict.pmc))
        return GRAZE_OK;
    if (scene->options.operation == GRAZE_SWEEP)
        return decide_on(out, context, scene, point);
    finding_set(out, GRAZE_TOPO_BOUNDARY, GRAZE_LEVEL_WORD);
    return GRAZE_OK;
}

graze_status topo_regular(topo_finding *out, graze_context *context, const graze_scene *scene,
                          const fmpq *point, const graze_trace *trace) {
    if (decide_by_word(out, trace->verdict.pmc))
        return GRAZE_OK;
    TRY(decide_on(out, context, scene, point));
    if (out->position == GRAZE_TOPO_INTERIOR)
        out->position = GRAZE_TOPO_EXTERIOR;
    return GRAZE_OK;
}
