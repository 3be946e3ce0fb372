/* The ground is made under the lock of the scene's memo.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "distance/ground.h"

#include <stdlib.h>
#include "distance/square.h"

/* 1 if the linear part L of a map satisfies L^T L = W^2 I, as polynomials. */
static int is_rigid(const point_map *map) {
    int d = map->dimension, rigid = 1;
    fmpz_poly_t sum, term, square;
    fmpz_poly_init(sum);
    fmpz_poly_init(term);
    fmpz_poly_init(square);
    fmpz_poly_sqr(square, map->weight);
    for (int i = 0; i < d && rigid; i++)
        for (int j = i; j < d && rigid; j++) {
            fmpz_poly_zero(sum);
            for (int k = 0; k < d; k++) {
                fmpz_poly_mul(term, &map->entry[k * (d + 1) + i], &map->entry[k * (d + 1) + j]);
                fmpz_poly_add(sum, sum, term);
            }
            rigid = i == j ? fmpz_poly_equal(sum, square) : fmpz_poly_is_zero(sum);
        }
    fmpz_poly_clear(sum);
    fmpz_poly_clear(term);
    fmpz_poly_clear(square);
    return rigid;
}

static void free_ground(void *value) {
    ground *g = value;
    for (size_t k = 0; k < g->tracing->piece_count; k++)
        carrier_clear(&g->piece[k].placing);
    free(g->piece);
    free(g);
}

static graze_status make_pieces(ground *g, graze_context *context) {
    const graze_motion *motion = g->scene->motion;
    graze_operation operation = g->scene->options.operation;
    for (size_t k = 0; k < motion->piece_count; k++) {
        ground_piece *piece = &g->piece[k];
        piece->rigid = is_rigid(motion_tracing(&motion->piece[k], operation));
        if (!piece->rigid &&
            !carrier_make(&piece->placing, motion_placing(&motion->piece[k], operation)))
            return context_fail(context, GRAZE_ESYSTEM, "out of memory for the maps of a motion");
        if (!g->tracing->piece[k].usable || (!piece->rigid && !piece->placing.usable))
            return context_fail(context, GRAZE_ELIMIT,
                                "piece %zu of the motion: a degree or a coefficient is beyond what "
                                "distances are computed for; expected a degree of at most %d",
                                k, CARRIER_DEGREE);
        if (!piece->rigid && g->tracing->piece[k].degree > SQUARED)
            return context_fail(context, GRAZE_ELIMIT,
                                "piece %zu of the motion: degree %d without being rigid is beyond "
                                "what distances are computed for; expected at most %d",
                                k, g->tracing->piece[k].degree, SQUARED);
    }
    return GRAZE_OK;
}

static graze_status make_ground(scene_memo *memo, graze_context *context,
                                const graze_scene *scene) {
    if (!scene->solid->corners.at)
        return context_fail(context, GRAZE_ELIMIT,
                            "a coordinate of the solid is too large for distances; expected at "
                            "most 2^200");
    ground *made = calloc(1, sizeof *made);
    ground_piece *piece = calloc(scene->motion->piece_count, sizeof *piece);
    if (!made || !piece) {
        free(made);
        free(piece);
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for the maps of a motion");
    }
    made->scene = scene;
    made->tracing = &scene->filter.course;
    made->piece = piece;
    graze_status status = make_pieces(made, context);
    if (status) {
        free_ground(made);
        return status;
    }
    memo->value = made;
    memo->free = free_ground;
    return GRAZE_OK;
}

graze_status ground_of(const ground **out, graze_context *context, const graze_scene *scene) {
    scene_memo *memo = scene->ground;
    graze_status status = GRAZE_OK;
    pthread_mutex_lock(&memo->lock);
    if (!memo->value)
        status = make_ground(memo, context, scene);
    *out = memo->value;
    pthread_mutex_unlock(&memo->lock);
    return status;
}
