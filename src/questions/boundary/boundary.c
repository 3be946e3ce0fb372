/* Makes a boundary: the box, the contact points, the cells, the surface.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/boundary/sampling.h"

#include "base/context/array.h"
#include "base/context/scope.h"

/* Set the box: the caller's, or the scene's with a margin. */
static graze_status set_box(struct graze_boundary *b, graze_context *context, const fmpq *low,
                            const fmpq *high) {
    if (!low)
        TRY(scene_box(b->low, b->point, context, b->scene));
    for (int k = 0; k < b->dimension; k++) {
        if (low)
            fmpq_set(b->low + k, low + k);
        fmpq_sub(b->side + k, (high ? high : b->point) + k, b->low + k);
        if (fmpq_sgn(b->side + k) <= 0)
            return context_fail(context, GRAZE_EUSE, "the box is empty along axis %d", k);
        if (low)
            continue;
        fmpq_div_2exp(b->point + k, b->side + k, 4);
        fmpq_sub(b->low + k, b->low + k, b->point + k);
        fmpq_mul_2exp(b->point + k, b->point + k, 1);
        fmpq_add(b->side + k, b->side + k, b->point + k);
    }
    return GRAZE_OK;
}

static graze_status set_askers(struct graze_boundary *b, graze_context *context, int threads) {
    TRY(MAKE_ARRAY(context, b->askers, (size_t)threads, "the threads of a boundary"));
    b->threads = threads;
    for (int t = 0; t < threads; t++) {
        b->askers[t].boundary = b;
        b->askers[t].point = _fmpq_vec_init(3);
    }
    return GRAZE_OK;
}

static graze_status list_leaves(struct graze_boundary *b, graze_context *context) {
    size_t capacity = 0;
    for (size_t i = 0; i < b->cell_count; i++) {
        if (b->cells[i].child)
            continue;
        TRY(ARRAY_GROW(context, b->leaves, capacity, b->leaf_count + 1, "the cells of a boundary"));
        b->leaves[b->leaf_count++] = i;
    }
    return GRAZE_OK;
}

graze_status boundary_make(struct graze_boundary *b, graze_context *context,
                           const graze_scene *scene, const graze_boundary_options *options,
                           const fmpq *low, const fmpq *high) {
    memset(b, 0, sizeof *b);
    b->scene = scene;
    b->dimension = scene->motion->dimension;
    b->coarse = options->coarse;
    b->depth = options->depth;
    b->budget = options->budget;
    b->middles = options->middles;
    b->sharp = options->sharp;
    b->complete = 1;
    b->low = _fmpq_vec_init(9);
    b->side = b->low + 3;
    b->point = b->low + 6;
    TRY(set_box(b, context, low, high));
    TRY(set_askers(b, context, options->threads > 1 ? options->threads : 1));
    if (options->contacts >= options->budget)
        TRY(boundary_refuse_budget(context, b, options->contacts));
    TRY(demand_check(context, scene, (double)boundary_least_points(b, options->contacts),
                     "the points of a boundary"));
    TRY(boundary_contacts(context, b, options->contacts, options->seed));
    TRY(boundary_refine(context, b));
    TRY(boundary_surface(context, b));
    TRY(boundary_bisect(context, b));
    if (b->sharp)
        TRY(boundary_sharpen(context, b));
    return list_leaves(b, context);
}

void boundary_clear(struct graze_boundary *b) {
    _fmpq_vec_clear(b->low, 9);
    for (int t = 0; t < b->threads; t++)
        _fmpq_vec_clear(b->askers[t].point, 3);
    free(b->askers);
    for (size_t k = 0; k < 2 * b->vertices.count && b->shares; k++)
        fmpq_clear(b->shares + k);
    free(b->shares);
    for (size_t k = 0; k < b->feature_count; k++)
        feature_clear(&b->features[k]);
    free(b->features);
    free(b->patches);
    number_index_clear(&b->points);
    number_index_clear(&b->vertices);
    free(b->cells);
    free(b->leaves);
    free(b->contacts);
    free(b->work);
    free(b->corners);
}
