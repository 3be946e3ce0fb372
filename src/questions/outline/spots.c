/* Isolated lower points, and lower parts on irrational lines (proofs/outline.md C140).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A rational point is classified. A place that is not rational is no lower part if all of a small
 * box around it is in the solid's interior (for an unsweep: in its exterior) at one time.
 */
#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include <stdlib.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/order.h"
#include "base/number/rounding.h"
#include "base/number/vector.h"
#include "decide/verdict/verdict.h"
#include "questions/outline/arc_complex.h"

/* Images of a box's corners in the solid's frame, two rationals each. */
typedef struct corner_images {
    fmpq *at;
    box around;
} corner_images;

static int images_miss(const corner_images *c, const graze_solid *solid, size_t index) {
    const tree_node *node = &solid->boxes.node[index];
    if (!box_meets(&node->box, &c->around))
        return 1;
    if (node->child)
        return images_miss(c, solid, node->child) && images_miss(c, solid, node->child + 1);
    LOCAL_VEC(fmpz, form, 3);
    LOCAL(fmpq, sum);
    LOCAL(fmpq, term);
    int first = 0;
    (void)solid_plane(form, solid, node->simplex);
    for (int k = 0; k < 4; k++) {
        fmpq_set_fmpz(sum, form + 2);
        for (int i = 0; i < 2; i++) {
            fmpq_mul_fmpz(term, c->at + 2 * k + i, form + i);
            fmpq_add(sum, sum, term);
        }
        first = k ? first : fmpq_sgn(sum);
        if (!first || fmpq_sgn(sum) != first)
            return 0;
    }
    return 1;
}

/* Does the box, low and high x, low and high y, miss the solid's boundary at a time? */
static int misses_at(const graze_scene *scene, const fmpq *box_ends, size_t piece, const fmpq_t u) {
    LOCAL_VEC(fmpq, map, 6);
    LOCAL_VEC(fmpq, at, 8);
    LOCAL(fmpq, term);
    corner_images c = {at, {{0}, {0}}};
    point_map_at(map, motion_tracing(&scene->motion->piece[piece], scene->options.operation), u);
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 2; i++) {
            fmpq *x = at + 2 * k + i;
            double low, high;
            fmpq_mul(x, map + 3 * i, box_ends + (k & 1));
            fmpq_mul(term, map + 3 * i + 1, box_ends + 2 + (k >> 1));
            fmpq_add(x, x, term);
            fmpq_add(x, x, map + 3 * i + 2);
            rational_bounds(&low, &high, x);
            c.around.low[i] = k && c.around.low[i] < low ? c.around.low[i] : low;
            c.around.high[i] = k && c.around.high[i] > high ? c.around.high[i] : high;
        }
    return images_miss(&c, scene->solid, 0);
}

/* Look at one rational time in each gap of a trace with the state. */
static graze_status search_gaps(int *out, graze_context *context, const graze_scene *scene,
                                const graze_trace *trace, graze_state state, const fmpq *box_ends,
                                graze_time *start, graze_time *end) {
    LOCAL(fmpq, u);
    size_t piece, n = trace->contact_count;
    for (size_t k = 0; k <= n && !*out; k++) {
        graze_state here = k ? trace->contact[k - 1].right : trace->first;

        if (here != state)
            continue;
        TRY(time_between(&piece, u, context, k ? trace->contact[k - 1].to : start,
                         k < n ? trace->contact[k].from : end));
        *out = misses_at(scene, box_ends, piece, u);
    }
    return GRAZE_OK;
}

/* *out becomes 1 if it is proved that all of a box is in the interior of the closed sweep's moving
 * solid at one time (for an unsweep, of its complement). */
static graze_status is_surely_within(int *out, graze_context *context, const graze_scene *scene,
                                     const fmpq *box_ends) {
    int is_sweep = scene->options.operation == GRAZE_SWEEP;
    LOCAL_VEC(fmpq, middle, 2);
    HELD(algebraic, zero);
    HELD(algebraic, one);
    graze_trace trace;
    *out = 0;
    fmpq_one(one.value);
    for (int i = 0; i < 2; i++) {
        fmpq_add(middle + i, box_ends + 2 * i, box_ends + 2 * i + 1);
        fmpq_div_2exp(middle + i, middle + i, 1);
    }
    TRY(classify_point(&trace, context, scene, (query_point){.rational = middle}, TRACE_CONTACTS));
    graze_time *start = time_create(scene->motion, 0, &zero);
    graze_time *end = time_create(scene->motion, scene->motion->piece_count - 1, &one);
    graze_status status =
        start && end ? search_gaps(out, context, scene, &trace,
                                   is_sweep ? GRAZE_STATE_I : GRAZE_STATE_O, box_ends, start, end)
                     : context_fail(context, GRAZE_ESYSTEM, "out of memory for an outline");
    time_destroy(start);
    time_destroy(end);
    trace_clear(&trace);
    return status;
}

/* The box of a place, and whether it is proved to be within. */
static graze_status place_is_within(int *out, const graze_outline *o, graze_context *context,
                                    outline_curve *c, algebraic *s) {
    HELD(point_place, here);
    LOCAL_VEC(fmpq, ends, 4);
    TRY(outline_curve_place(here.xy, context, c, s, POINT_PLACES));
    for (int k = 0; k < 2; k++) {
        bracket_low(ends + 2 * k, &here.xy[k], POINT_PLACES);
        bracket_high(ends + 2 * k + 1, &here.xy[k], POINT_PLACES);
    }
    return is_surely_within(out, context, o->scene, ends);
}

/* Decide the pieces on irrational lines that may be lower parts. */
static graze_status decide_slants(graze_outline *o, graze_context *context) {
    HELD(algebraic, s);
    for (size_t k = 0; k < o->piece_count; k++) {
        outline_piece *p = &o->piece[k];
        int within = 0;
        if (p->lower != -1)
            continue;
        TRY(piece_middle(s.value, context, o, p));
        TRY(place_is_within(&within, o, context, &o->curve[p->curve], &s));
        p->lower = within ? 0 : -1;
        o->undecided += !within;
    }
    return GRAZE_OK;
}

/* Is a cut's place, which may be rational, a point at which boundary or lower pieces end? */
static graze_status is_point(int *out, graze_outline *o, graze_context *context, size_t curve,
                             size_t cut) {
    outline_point here = {.curve = curve, .cut = cut};
    outline_curve *c = &o->curve[curve];
    graze_status status = GRAZE_OK;
    *out = 0;
    for (int k = 0; k < 2; k++) {
        bracket_init(&here.place[k]);
        algebraic_init(&here.coordinate[k]);
    }
    status = outline_curve_place(here.place, context, c, c->cut[cut], POINT_PLACES);
    for (size_t k = 0; k < o->point_count && !status && !*out; k++) {
        outline_point *p = &o->point[k];
        if (p->vertex == k && bracket_meets(&p->place[0], &here.place[0]) &&
            bracket_meets(&p->place[1], &here.place[1]))
            status = points_equal(out, o, context, p, &here);
    }
    for (int k = 0; k < 2; k++) {
        bracket_clear(&here.place[k]);
        algebraic_clear(&here.coordinate[k]);
    }
    return status;
}

static graze_status add_spot(graze_outline *o, graze_context *context, const fmpq *point) {
    size_t before = o->spot_capacity;
    for (size_t k = 0; k < o->spot_count; k++)
        if (vector_compare(o->spot + 2 * k, point, 2) == 0)
            return GRAZE_OK;
    TRY(array_grow(context, &o->spot, &o->spot_capacity, o->spot_count + 1, 2 * sizeof *o->spot,
                   "the points of an outline"));
    for (size_t k = 2 * before; k < 2 * o->spot_capacity; k++)
        fmpq_init(o->spot + k);
    vector_set(o->spot + 2 * o->spot_count++, point, 2);
    return GRAZE_OK;
}

/* A cut of a curve: is it an isolated lower point? */
static graze_status decide_cut(graze_outline *o, graze_context *context, size_t curve, size_t cut) {
    outline_curve *c = &o->curve[curve];
    LOCAL_VEC(fmpq, point, 2);
    number_reduce(c->cut[cut]);
    int known = 0, is_rational = !c->slant && algebraic_is_rational(c->cut[cut]);
    if (is_rational) {
        graze_verdict verdict;
        outline_curve_at(point, c, c->cut[cut]->value);
        TRY(classify_answer(&verdict, context, o->scene, (query_point){.rational = point},
                            TRACE_PMC));
        known = verdict.pmc != GRAZE_ON;
    } else {
        TRY(place_is_within(&known, o, context, c, c->cut[cut]));
    }
    if (!known)
        TRY(is_point(&known, o, context, curve, cut));
    if (known)
        return context_poll(context);
    o->undecided += !is_rational;
    return is_rational ? add_spot(o, context, point) : GRAZE_OK;
}

graze_status outline_spots(graze_outline *o, graze_context *context) {
    TRY(decide_slants(o, context));
    for (size_t k = 0; k < o->curve_count; k++)
        for (size_t cut = 0; cut < o->curve[k].cut_count; cut++)
            TRY(decide_cut(o, context, k, cut));
    return GRAZE_OK;
}
