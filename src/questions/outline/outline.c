/* The steps from a scene to its outline.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/scope.h"
#include "questions/outline/arc_complex.h"

const char *const curve_source_names[] = {"path", "edge", "envelope"};

static void turn_order_clear(turn_order *t) {
    free(t->next);
    free(t->previous);
}

graze_status outline_make(graze_outline *o, graze_context *context, const graze_scene *scene,
                          double width) {
    ZEROED(turn_order, turns);
    o->scene = scene;
    o->width = width;
    fmpz_mpoly_ctx_init(o->ring_of_forms, FORM_VARIABLES, ORD_LEX);
    measure_init(&o->area);
    measure_init(&o->length);
    TRY(outline_candidates(o, context));
    TRY(outline_cover(o, context));
    TRY(outline_open_parts(o, context));
    TRY(outline_equations(o, context));
    TRY(outline_cuts(o, context));
    TRY(outline_pieces(o, context));
    TRY(outline_sides(o, context));
    TRY(outline_points(o, context));
    TRY(outline_turns(&turns, o, context));
    TRY(outline_arcs(o, context, &turns));
    TRY(outline_walks(o, context, &turns));
    TRY(outline_measures(o, context));
    TRY(outline_nesting(o, context));
    return outline_spots(o, context);
}

static void clear_rings(outline_ring *ring, size_t count) {
    for (size_t k = 0; k < count; k++) {
        measure_clear(&ring[k].area);
        measure_clear(&ring[k].length);
    }
    free(ring);
}

static void clear_equations(graze_outline *o) {
    for (size_t k = 0; k < o->equation_count; k++) {
        outline_equation *e = &o->equation[k];
        for (size_t i = 0; i < e->point_count; i++)
            fmpz_poly_clear(&e->point[i]);
        free(e->point);
        fmpz_mpoly_clear(e->form, o->ring_of_forms);
    }
    free(o->equation);
}

static void clear_points(graze_outline *o) {
    for (size_t k = 0; k < o->point_count; k++)
        for (int i = 0; i < 2; i++) {
            bracket_clear(&o->point[k].place[i]);
            algebraic_clear(&o->point[k].coordinate[i]);
        }
    free(o->point);
}

static void clear_rationals(fmpq *x, size_t count) {
    for (size_t k = 0; k < count; k++)
        fmpq_clear(x + k);
    free(x);
}

void outline_clear(graze_outline *o) {
    if (!o->scene)
        return;
    for (size_t k = 0; k < o->curve_count; k++)
        outline_curve_clear(&o->curve[k]);
    free(o->curve);
    covering_clear(&o->cover);
    clear_equations(o);
    clear_rationals(o->fixed, 2 * o->fixed_capacity);
    clear_rationals(o->spot, 2 * o->spot_capacity);
    for (size_t k = 0; k < o->piece_count; k++)
        for (int i = 0; i < 4; i++)
            fmpq_clear(&o->piece[k].sample[i]);
    free(o->piece);
    clear_points(o);
    for (size_t k = 0; k < o->arc_count; k++) {
        measure_clear(&o->arc[k].area);
        measure_clear(&o->arc[k].length);
    }
    free(o->arc);
    free(o->arc_piece);
    free(o->ring_arc);
    clear_rings(o->ring, o->ring_count);
    clear_rings(o->around, o->around_count);
    measure_clear(&o->area);
    measure_clear(&o->length);
    fmpz_mpoly_ctx_clear(o->ring_of_forms);
}

size_t outline_lower_count(const graze_outline *o) {
    size_t count = 0;
    for (size_t k = 0; k < o->piece_count; k++)
        count += o->piece[k].lower == 1;
    return count;
}
