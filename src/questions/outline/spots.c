/* Isolated lower points, and lower parts on irrational lines (proofs/outline.md C143).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A rational point is classified. A place that is not rational is no lower part if all of a small
 * box around it is in the solid's interior (for an unsweep: in its exterior) at one time.
 */
#include "base/context/scope.h"
#include "base/number/vector.h"
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

/* Does the box between two corners miss the solid's boundary at a time? */
static int misses_at(const graze_scene *scene, const fmpq *corner, size_t piece, const fmpq_t u) {
    LOCAL_VEC(fmpq, map, 6);
    LOCAL_VEC(fmpq, at, 8);
    corner_images c = {.at = at};
    box_empty(&c.around);
    point_map_at(map, motion_tracing(&scene->motion->piece[piece], scene->options.operation), u);
    for (int k = 0; k < 4; k++) {
        for (int i = 0; i < 2; i++) {
            fmpq *x = at + 2 * k + i;
            fmpq_set(x, map + 3 * i + 2);
            fmpq_addmul(x, map + 3 * i, corner + 2 * (k & 1));
            fmpq_addmul(x, map + 3 * i + 1, corner + 2 * (k >> 1) + 1);
        }
        box_add_point(&c.around, at + 2 * k);
    }
    return images_miss(&c, scene->solid, 0);
}

/* Look at one rational time in each gap of a trace with the state. */
static graze_status search_gaps(int *out, graze_context *context, const graze_scene *scene,
                                const graze_trace *trace, graze_state state, const fmpq *corner,
                                graze_time *start, graze_time *end) {
    LOCAL(fmpq, u);
    size_t piece, n = trace->contact_count;
    for (size_t k = 0; k <= n && !*out; k++) {
        if ((k ? trace->contact[k - 1].right : trace->first) != state)
            continue;
        TRY(time_between(&piece, u, context, k ? trace->contact[k - 1].to : start,
                         k < n ? trace->contact[k].from : end));
        *out = misses_at(scene, corner, piece, u);
    }
    return GRAZE_OK;
}

/* *out becomes 1 if it is proved that all of a box is in the interior of the closed sweep's moving
 * solid at one time (for an unsweep, of its complement). */
static graze_status is_surely_within(int *out, graze_context *context, const graze_scene *scene,
                                     const fmpq *corner) {
    int is_sweep = scene->options.operation == GRAZE_SWEEP;
    LOCAL_VEC(fmpq, middle, 2);
    HELD(algebraic, zero);
    HELD(algebraic, one);
    graze_trace trace;
    *out = 0;
    fmpq_one(one.value);
    vector_middle(middle, corner, corner + 2, 2);
    TRY(classify_point(&trace, context, scene, (query_point){.rational = middle}, TRACE_CONTACTS));
    graze_time *start = time_create(scene->motion, 0, &zero);
    graze_time *end = time_create(scene->motion, scene->motion->piece_count - 1, &one);
    graze_status status =
        start && end ? search_gaps(out, context, scene, &trace,
                                   is_sweep ? GRAZE_STATE_I : GRAZE_STATE_O, corner, start, end)
                     : context_fail(context, GRAZE_ESYSTEM, "out of memory for an outline");
    time_destroy(start);
    time_destroy(end);
    trace_clear(&trace);
    return status;
}

/* Is the box of a place proved to be within, at a number of binary places? */
static graze_status place_is_within(int *out, const graze_outline *o, graze_context *context,
                                    outline_curve *c, algebraic *s, ulong places) {
    LOCAL_VEC(fmpq, corner, 4);
    TRY(outline_curve_corners(corner, context, c, s, places));
    return is_surely_within(out, context, o->scene, corner);
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
        TRY(place_is_within(&within, o, context, &o->curve[p->curve], &s, POINT_PLACES));
        p->lower = within ? 0 : -1;
        o->undecided += !within;
    }
    return GRAZE_OK;
}

/* Is a cut's place, which may be rational, a point at which boundary or lower pieces end? */
static graze_status is_point(int *out, graze_outline *o, graze_context *context, size_t curve,
                             size_t cut) {
    HELD(outline_point, here, curve, cut);
    outline_curve *c = &o->curve[curve];
    *out = 0;
    TRY(outline_curve_place(here.place, context, c, c->cut[cut], POINT_PLACES));
    for (size_t k = 0; k < o->point_count && !*out; k++) {
        outline_point *p = &o->point[k];
        if (p->vertex == k && bracket_meets(&p->place[0], &here.place[0]) &&
            bracket_meets(&p->place[1], &here.place[1]))
            TRY(points_equal(out, o, context, p, &here));
    }
    return GRAZE_OK;
}

static graze_status add_spot(graze_outline *o, graze_context *context, const fmpq *point) {
    for (size_t k = 0; k < o->spot_count; k++)
        if (vector_compare(o->spot + 2 * k, point, 2) == 0)
            return GRAZE_OK;
    return outline_keep_point(&o->spot, &o->spot_count, &o->spot_capacity, context, point);
}

/* A cut of a curve: is it an isolated lower point? */
static graze_status decide_cut(graze_outline *o, graze_context *context, size_t curve, size_t cut) {
    outline_curve *c = &o->curve[curve];
    LOCAL_VEC(fmpq, point, 2);
    box around;
    TRY(outline_place_box(&around, context, c, c->cut[cut]));
    if (outline_covers(o, &around, c->piece))
        return GRAZE_OK;
    number_reduce(c->cut[cut]);
    int known = 0, is_rational = !c->slant && algebraic_is_rational(c->cut[cut]);
    if (is_rational) {
        graze_pmc pmc;
        outline_curve_at(point, c, c->cut[cut]->value);
        TRY(outline_pmc(&pmc, o, context, point, TRACE_PMC));
        known = pmc != GRAZE_ON;
    } else {
        TRY(place_is_within(&known, o, context, c, c->cut[cut], POINT_PLACES));
    }
    if (!known)
        TRY(is_point(&known, o, context, curve, cut));
    for (ulong finer = 4; !known && !is_rational && finer <= 16; finer *= 4)
        TRY(place_is_within(&known, o, context, c, c->cut[cut], finer * POINT_PLACES));
    if (known)
        return context_poll(context);
    o->undecided += !is_rational;
    return is_rational ? add_spot(o, context, point) : GRAZE_OK;
}

graze_status outline_spots(graze_outline *o, graze_context *context) {
    TRY(decide_slants(o, context));
    size_t next = 0; /* points are in the order of curves and their cuts */
    for (size_t k = 0; k < o->curve_count; k++)
        for (size_t cut = 0; cut < o->curve[k].cut_count; cut++)
            if (next < o->point_count && o->point[next].curve == k && o->point[next].cut == cut)
                next++;
            else
                TRY(decide_cut(o, context, k, cut));
    return GRAZE_OK;
}
