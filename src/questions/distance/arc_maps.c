/* The maps are made under the lock of the scene's memo.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/distance/gap.h"

#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"

/* 1 if the map keeps distances. */
static int is_rigid(const point_map *map) {
    LOCAL_VEC(fmpz_poly, scale, 2);
    fmpz_poly_sqr(scale + 1, map->weight);
    return point_map_scale(scale, map) && fmpz_poly_equal(scale, scale + 1);
}

/* The coefficients of a weight on an arc differ by no more than this factor. */
static const double MOST_VARIATION = 0x1p10;
/* An arc is no shorter than 2^-DEEPEST of its piece, and begins at a multiple of its length that a
 * double holds. */
enum { DEEPEST = 900, MOST_BITS = 52 };

const carrier *arc_maps_tracing(const arc_maps *g, size_t index) {
    const arc *a = &g->arc[index];
    return a->tracing.entry ? &a->tracing : &g->whole->piece[a->piece];
}

static void arc_clear(arc *a) {
    carrier_clear(&a->tracing);
    carrier_clear(&a->placing);
}

static void free_ground(void *value) {
    arc_maps *g = value;
    for (size_t k = 0; k < g->arc_count; k++)
        arc_clear(&g->arc[k]);
    if (g->tree->value)
        g->tree->free(g->tree->value);
    pthread_mutex_destroy(&g->tree->lock);
    free(g->tree);
    free(g->arc);
    free(g->first);
    free(g);
}

static int is_even(const carrier *c) {
    double least = c->weight[0], most = least;
    for (int k = 1; k <= c->degree; k++) {
        least = c->weight[k] < least ? c->weight[k] : least;
        most = c->weight[k] > most ? c->weight[k] : most;
    }
    return least * MOST_VARIATION >= most;
}

static graze_status no_memory_for_maps(graze_context *context) {
    return context_fail(context, GRAZE_ESYSTEM, "out of memory for the maps of a motion");
}

static graze_status check_arc(graze_context *context, const arc *a, const carrier *tracing) {
    if (!tracing->usable || (!a->rigid && !a->placing.usable))
        return context_fail(context, GRAZE_ELIMIT,
                            "piece %zu of the motion: a degree or a coefficient is beyond what "
                            "distances are computed for; expected a degree of at most %d",
                            a->piece, CARRIER_DEGREE);
    if (!a->rigid && tracing->degree > SQUARED)
        return context_fail(context, GRAZE_ELIMIT,
                            "piece %zu of the motion: degree %d without being rigid is beyond "
                            "what distances are computed for; expected at most %d",
                            a->piece, tracing->degree, SQUARED);
    return GRAZE_OK;
}

/* Append an arc; the list takes the maps of `a`, which is left without them. */
static graze_status keep_arc(arc_maps *g, graze_context *context, arc *a, ulong depth) {
    TRY(context_poll(context));
    TRY(ARRAY_GROW(context, g->arc, g->arc_capacity, g->arc_count + 1, "the maps of a motion"));
    g->arc[g->arc_count++] = *a;
    a->tracing = a->placing = (carrier){0};
    g->deepest = depth > g->deepest ? depth : g->deepest;
    return GRAZE_OK;
}

static graze_status make_arcs(arc_maps *g, graze_context *context, size_t piece, int rigid,
                              const dyadic_interval *part);

static graze_status make_halves(arc_maps *g, graze_context *context, size_t piece, int rigid,
                                const dyadic_interval *part) {
    if (part->exponent == DEEPEST || fmpz_bits(part->low) >= MOST_BITS)
        return context_fail(context, GRAZE_ELIMIT,
                            "piece %zu of the motion: the common denominator of its matrix varies "
                            "too much for distances; expected a piece cut where it is smallest",
                            piece);
    HELD(dyadic_interval, left);
    HELD(dyadic_interval, right);
    dyadic_interval_halves(&left, &right, part);
    TRY(make_arcs(g, context, piece, rigid, &left));
    return make_arcs(g, context, piece, rigid, &right);
}

/* Append the arcs of a part of a piece: the part itself or, if a weight varies too much, the arcs
 * of its halves. */
static graze_status make_arcs(arc_maps *g, graze_context *context, size_t piece, int rigid,
                              const dyadic_interval *part) {
    const motion_piece *of = &g->scene->motion->piece[piece];
    graze_operation operation = g->scene->options.operation;
    double length = ldexp(1, -(int)part->exponent);
    int whole = part->exponent == 0;
    ZEROED(arc, a);
    a = (arc){piece, fmpz_get_d(part->low) * length, length, rigid, {0}, {0}};
    const carrier *tracing = whole ? &g->whole->piece[piece] : &a.tracing;
    int made = whole || carrier_make_on(&a.tracing, motion_tracing(of, operation), part);
    made = made && (rigid || carrier_make_on(&a.placing, motion_placing(of, operation), part));
    TRY(made ? check_arc(context, &a, tracing) : no_memory_for_maps(context));
    if (is_even(tracing) && (rigid || is_even(&a.placing)))
        return keep_arc(g, context, &a, part->exponent);
    return make_halves(g, context, piece, rigid, part);
}

static graze_status make_pieces(arc_maps *g, graze_context *context) {
    const graze_motion *motion = g->scene->motion;
    graze_operation operation = g->scene->options.operation;
    HELD(dyadic_interval, unit);
    dyadic_interval_set_si(&unit, 0, 1);
    for (size_t k = 0; k < motion->piece_count; k++) {
        g->first[k] = g->arc_count;
        int rigid = is_rigid(motion_tracing(&motion->piece[k], operation));
        TRY(make_arcs(g, context, k, rigid, &unit));
    }
    g->first[motion->piece_count] = g->arc_count;
    return GRAZE_OK;
}

static graze_status make_ground(scene_memo *memo, graze_context *context,
                                const graze_scene *scene) {
    if (!scene->solid->corners.at)
        return context_fail(context, GRAZE_ELIMIT,
                            "a coordinate of the solid is too large for distances; expected at "
                            "most 2^200");
    arc_maps *made = calloc(1, sizeof *made);
    size_t *first = calloc(scene->motion->piece_count + 1, sizeof *first);
    scene_memo *tree = calloc(1, sizeof *tree);
    if (!made || !first || !tree) {
        free(made);
        free(first);
        free(tree);
        return no_memory_for_maps(context);
    }
    pthread_mutex_init(&tree->lock, NULL);
    made->tree = tree;
    made->scene = scene;
    made->whole = &scene->filter.course;
    made->first = first;
    graze_status status = make_pieces(made, context);
    if (status) {
        free_ground(made);
        return status;
    }
    memo->value = made;
    memo->free = free_ground;
    return GRAZE_OK;
}

graze_status arc_maps_of(const arc_maps **out, graze_context *context, const graze_scene *scene) {
    scene_memo *memo = scene->arc_maps;
    graze_status status = GRAZE_OK;
    pthread_mutex_lock(&memo->lock);
    if (!memo->value)
        status = make_ground(memo, context, scene);
    *out = memo->value;
    pthread_mutex_unlock(&memo->lock);
    return status;
}
