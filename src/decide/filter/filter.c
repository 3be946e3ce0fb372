/* The filter of a scene, and the search for one point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdlib.h>
#include "decide/filter/search.h"

graze_status filter_make(filter *out, graze_context *context, const graze_solid *solid,
                         const graze_motion *motion, graze_operation operation) {
    *out = (filter){.solid = solid};
    out->proves = operation == GRAZE_UNSWEEP ? GRAZE_STATE_O : GRAZE_STATE_I;
    out->bricks = calloc(1, sizeof *out->bricks);
    if (out->bricks)
        pthread_mutex_init(&out->bricks->lock, NULL);
    return out->bricks && course_make(&out->course, motion, operation)
               ? GRAZE_OK
               : context_fail(context, GRAZE_ESYSTEM, "out of memory for the filter of %zu pieces",
                              motion->piece_count);
}

void filter_clear(filter *f) {
    course_clear(&f->course);
    if (f->bricks) {
        interior_clear(&f->bricks->all);
        pthread_mutex_destroy(&f->bricks->lock);
    }
    free(f->bricks);
    *f = (filter){.solid = NULL};
}

const interior *filter_bricks(const filter *f) {
    return atomic_load(&f->bricks->laid) ? &f->bricks->all : NULL;
}

static void workspace_free(void *memory) {
    filter_workspace *w = memory;
    curve_clear(&w->curve);
    curve_clear(&w->ray);
    findings_clear(&w->found);
    findings_clear(&w->ray_found);
    form_memory_clear(&w->forms);
    surface_curve_clear(&w->along);
    truths_clear(&w->truths);
    free(w);
}

filter_workspace *filter_workspace_of(graze_context *context) {
    if (!context->workspace) {
        context->workspace = calloc(1, sizeof(filter_workspace));
        context->workspace_free = workspace_free;
    }
    return context->workspace;
}

void filter_begin(filter_workspace *w) {
    w->set = 0;
}

int filter_set(filter_workspace *w, const filter *f, const filter_point *point) {
    const corners *corners = &f->solid->corners;
    if (!w->set)
        w->set = corners->at && curve_set(&w->curve, &f->course, point, corners);
    return w->set;
}

int filter_search(filter_workspace *w, int *settled, const interior *bricks, const filter *f,
                  const filter_point *point) {
    findings *found = &w->found;
    early_end early = {bricks, f->proves, 0};
    if (!filter_set(w, f, point) ||
        !search_curve(found, settled ? &early : NULL, &w->curve, f->solid))
        return 0;
    if (settled)
        *settled = early.met;
    return early.met || findings_settle(found);
}
