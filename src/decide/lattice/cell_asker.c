/* Decides a cell if all its points miss the boundary, or if all are joined with an anchor.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/lattice/lattice.h"

#include "base/context/scope.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"

void cell_asker_init(cell_asker *out, graze_context *context, const graze_scene *scene) {
    *out = (cell_asker){.context = context, .scene = scene};
}

void cell_asker_clear(cell_asker *a) {
    curve_clear(&a->tube);
}

static filter_point centre_of(const point_box *points) {
    filter_point centre;
    memcpy(centre.at, points->centre, sizeof centre.at);
    return centre;
}

/* Membership of all points of a clear cell: their words have one letter, that of the centre at the
 * beginning of the motion. NONE if that is not certain. */
static graze_pmc membership_of_clear(const cell_asker *a, const point_box *points) {
    filter_workspace *w = filter_workspace_of(a->context);
    filter_point centre = centre_of(points);
    if (!w)
        return GRAZE_PMC_NONE;
    filter_begin(w);
    graze_state state = filter_locate(w, &a->scene->filter, 0, &centre, 0);
    return state == GRAZE_STATE_I ? GRAZE_IN : state == GRAZE_STATE_O ? GRAZE_OUT : GRAZE_PMC_NONE;
}

/* The filter's findings for the centre of a cell; NULL if the filter cannot be used for it. */
static const findings *search_centre(const cell_asker *a, const point_box *points) {
    filter_workspace *w = filter_workspace_of(a->context);
    filter_point centre = centre_of(points);
    if (w)
        filter_begin(w);
    return w && filter_search(w, NULL, NULL, &a->scene->filter, &centre) ? &w->found : NULL;
}

int cell_certain_times(piece_time when[CERTAIN_TIMES_MOST], const cell_asker *a,
                       const point_box *points) {
    const findings *found = search_centre(a, points);
    return found ? certain_times_find(when, found, a->scene->motion->piece_count,
                                      a->scene->options.operation == GRAZE_UNSWEEP)
                 : 0;
}

/* Replace the anchors by those around the places of a cell's centre at certain times, if such times
 * are found; else change nothing. */
static void find_anchors(anchors *out, cell_asker *a, const point_box *points) {
    piece_time when[CERTAIN_TIMES_MOST];
    int count = cell_certain_times(when, a, points);
    if (count)
        out->count = 0;
    for (int k = 0; k < count; k++) {
        anchor *next = &out->item[out->count];
        next->when = when[k];
        out->count +=
            point_box_places(&next->around, &a->tube, &a->scene->filter, &next->when, NULL);
    }
}

int cell_joins(cell_asker *a, const point_box *points, const anchors *near) {
    for (int k = 0; k < near->count; k++)
        if (point_box_joins(&a->tube, &a->scene->filter, points, &near->item[k]))
            return 1;
    return 0;
}

graze_pmc cell_membership_proved(const cell_asker *a) {
    return a->scene->options.operation == GRAZE_UNSWEEP ? GRAZE_OUT : GRAZE_IN;
}

graze_pmc cell_decide(cell_asker *a, const point_box *points, anchors *near, int smallest) {
    const filter *f = &a->scene->filter;
    if (!point_box_begin(&a->tube, f, points))
        return GRAZE_PMC_NONE;
    if (near->count ? cell_joins(a, points, near)
                    : point_box_is_settled(&a->tube, f, points, &a->time))
        return cell_membership_proved(a);
    if (point_box_is_clear(&a->tube, f, points))
        return membership_of_clear(a, points);
    if (smallest)
        return GRAZE_PMC_NONE;
    find_anchors(near, a, points);
    return cell_joins(a, points, near) ? cell_membership_proved(a) : GRAZE_PMC_NONE;
}

/* Have corners of a cell two memberships? Then no test can show that all its points have one. A
 * corner whose exact answer meets a limit tells nothing. */
static graze_status corners_differ(int *differ, cell_asker *a, const point_box *points) {
    graze_pmc first = GRAZE_PMC_NONE;
    *differ = 0;
    for (int k = 0; k < 8 && a->corners && !*differ; k++) {
        graze_verdict verdict;
        int corner = k / 2 ^ (k % 2 ? 7 : 0); /* opposite corners one after the other */
        double at[3];
        for (int i = 0; i < 3; i++)
            at[i] = points->centre[i] + (corner >> i & 1 ? points->half[i] : -points->half[i]);
        graze_status status =
            classify_answer(&verdict, a->context, a->scene, (query_point){.value = at}, TRACE_PMC);
        if (status == GRAZE_ELIMIT)
            return GRAZE_OK;
        TRY(status);
        first = k ? first : verdict.pmc;
        *differ = verdict.pmc != first;
    }
    return GRAZE_OK;
}

/* Decide a cell through which the boundary passes: if a facet crosses all of it, or if no point of
 * it is `on`. */
static graze_status decide_passage(graze_pmc *pmc, cell_asker *a, const point_box *points) {
    const filter *f = &a->scene->filter;
    int differ;
    TRY(corners_differ(&differ, a, points));
    if (differ || !point_box_begin(&a->tube, f, points))
        return GRAZE_OK;
    cell_passage found = cell_passes(&a->tube, f, points, NULL, NULL);
    if (found == CELL_PIERCED)
        *pmc = cell_membership_proved(a);
    if (found != CELL_PASSES)
        return GRAZE_OK;
    graze_verdict verdict;
    TRY(classify_answer(&verdict, a->context, a->scene, (query_point){.value = points->centre},
                        TRACE_PMC_BESIDE));
    *pmc = verdict.pmc;
    return GRAZE_OK;
}

/* Tests that run out of memory have nothing certain, and say so here. */
static graze_status status_of_memory(const cell_asker *a) {
    const filter_workspace *w = filter_workspace_of(a->context);
    if (a->tube.out_of_memory || !w || w->curve.out_of_memory)
        return context_fail(a->context, GRAZE_ESYSTEM, "out of memory for cells of space");
    return GRAZE_OK;
}

graze_status cell_certain(graze_pmc *out, cell_asker *a, const point_box *points, anchors *near) {
    *out = cell_decide(a, points, near, 0);
    graze_status status = *out == GRAZE_PMC_NONE ? decide_passage(out, a, points) : GRAZE_OK;
    return status ? status : status_of_memory(a);
}

graze_status cell_part_has(int *out, cell_asker *a, const point_box *points,
                           const cell_walls *walls, const fmpq *inside, graze_pmc pmc) {
    const filter *f = &a->scene->filter;
    graze_verdict verdict;
    *out = 0;
    TRY(classify_answer(&verdict, a->context, a->scene, (query_point){.rational = inside},
                        TRACE_PMC_BESIDE));
    if (verdict.pmc == pmc && point_box_begin(&a->tube, f, points))
        *out = cell_passes(&a->tube, f, points, walls, a->scene->motion) != CELL_DOUBTFUL;
    return GRAZE_OK;
}

graze_status cell_slab_find(graze_pmc side[2], cell_slab *slab, cell_asker *a) {
    point_box points = {.half = {slab->half, slab->half, slab->half}};
    cell_walls walls = {.slab = slab};
    const filter *f = &a->scene->filter;
    memcpy(points.centre, slab->centre, sizeof points.centre);
    side[0] = side[1] = GRAZE_PMC_NONE;
    if (!point_box_begin(&a->tube, f, &points))
        return status_of_memory(a);
    (void)cell_passes(&a->tube, f, &points, &walls, a->scene->motion);
    int found = cell_slab_turn(slab) &&
                cell_passes(&a->tube, f, &points, &walls, a->scene->motion) == CELL_PASSES;
    TRY(status_of_memory(a));
    if (!found)
        return GRAZE_OK;
    if (slab->low > slab->high)
        slab->low = slab->high = slab->reach; /* all of the cube is below */
    for (int above = 0; above < 2; above++) {
        double at[3];
        graze_verdict verdict;
        if (!cell_slab_beside(at, slab, above))
            continue;
        graze_status status = classify_answer(&verdict, a->context, a->scene,
                                              (query_point){.value = at}, TRACE_PMC_BESIDE);
        if (status == GRAZE_ELIMIT)
            continue; /* nothing is known of this side */
        TRY(status);
        side[above] = verdict.pmc;
    }
    return GRAZE_OK;
}
