/* Draws a point of a surface and a time, and traces the point exactly to see whether it is a
 * contact then.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/generate/charts.h"

#include "base/context/scope.h"
#include "base/number/vector.h"
#include "decide/curved/curved.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"
#include "questions/generate/strata.h"

/* One draw: a body point y, a time, and the solid near y. */
typedef struct touchpoint {
    graze_context *context;
    const struct graze_generator *g;
    const instant *when;
    instant own; /* set if `when` points to it */
    fmpq *y;
    dependence at;  /* the surfaces on whose signs the solid near y depends */
    int isolated;   /* a singular point of an intersection */
    int kind;       /* dimension of the cell of y; -1: y is not on the boundary */
    size_t surface; /* one of the surfaces of `at` */
    fmpz *form;     /* its tangent plane, positive outside; all 0 at an apex */
    graze_sample *made;
} touchpoint;

static void touchpoint_init(touchpoint *p, graze_context *context,
                            const struct graze_generator *g) {
    *p = (touchpoint){.context = context, .g = g, .kind = -1};
    p->y = _fmpq_vec_init(3);
    p->form = _fmpz_vec_init(4);
}

static void touchpoint_clear(touchpoint *p) {
    if (p->when == &p->own)
        instant_clear(&p->own);
    _fmpq_vec_clear(p->y, 3);
    _fmpz_vec_clear(p->form, 4);
}

static int draw_from(touchpoint *p, const charts *list, random_stream *r, const chart **from) {
    if (list->count == 0)
        return 0;
    *from = &list->item[random_below(r, list->count)];
    p->isolated = (*from)->isolated;
    return chart_draw(p->y, *from, r, &p->g->atlas->solid->box);
}

/* The gradient of a surface at y. */
static void surface_gradient(fmpq *out, const csg_surface *s, const fmpq *y, int d) {
    LOCAL(fmpq, term);
    for (int i = 0; i < d; i++) {
        fmpq_zero(out + i);
        for (size_t k = 0; k < s->count; k++) {
            fmpq_set_fmpz(term, s->coefficient + k);
            fmpq_mul_si(term, term, s->power[k][i]);
            for (int j = 0; j < d && !fmpq_is_zero(term); j++)
                for (int power = s->power[k][j] - (i == j); power > 0; power--)
                    fmpq_mul(term, term, y + j);
            fmpq_add(out + i, out + i, term);
        }
    }
}

/* form = gradient . (x - y), in integers */
static void tangent_plane(fmpz *form, const csg_surface *s, const fmpq *y, int d) {
    LOCAL_VEC(fmpq, plane, 4);
    LOCAL(fmpz, common);
    surface_gradient(plane, s, y, d);
    for (int i = 0; i < d; i++)
        fmpq_submul(plane + d, plane + i, y + i);
    _fmpq_vec_get_fmpz_vec_fmpz(form, common, plane, d + 1);
}

/* Draw a piece and a rational time in it at which y, a point of the surface, has normal velocity
 * zero; returns 0 if the piece has none. */
static int draw_time(touchpoint *p, size_t surface, random_stream *r) {
    const graze_scene *scene = p->g->scene;
    size_t piece = random_below(r, scene->motion->piece_count);
    LOCAL_VEC(fmpq, u, SPECIAL_ROOTS);
    LOCAL(fmpz_poly, velocity);
    tangent_plane(p->form, &p->g->atlas->solid->surface[surface], p->y, scene->motion->dimension);
    special_velocity(velocity, scene, piece, p->form, p->y);
    int found = special_roots(u, velocity);
    if (found) {
        instant_init(&p->own, scene, piece, u + random_below(r, (size_t)found));
        p->when = &p->own;
    }
    return found > 0;
}

/* Draw a point of a surface and a time at which its normal velocity is zero: with probability 1/2 a
 * point of the atlas's touches, which have their times, else a point of a face and then a time. */
static int draw_tangency(touchpoint *p, random_stream *r) {
    const chart *from;
    const atlas *a = p->g->atlas;
    if (random_below(r, 2) && a->touches.count) {
        int made = draw_from(p, &a->touches, r, &from);
        p->when = &p->g->instants[from->mark];
        return made;
    }
    return draw_from(p, &a->faces, r, &from) && draw_time(p, from->mark, r);
}

static int draw_touch(touchpoint *p, graze_stratum stratum, random_stream *r) {
    const atlas *a = p->g->atlas;
    const chart *from;
    size_t choice;
    p->when = stratum_instant(p->g, stratum, r);
    if (!p->when)
        return 0;
    switch (stratum) {
    case GRAZE_STRATUM_FACE:
    case GRAZE_STRATUM_FACE_ODD:
        return draw_tangency(p, r);
    case GRAZE_STRATUM_SLIDE:
        return random_below(r, 2) ? draw_tangency(p, r) : draw_from(p, &a->faces, r, &from);
    case GRAZE_STRATUM_EDGE:
        return draw_from(p, &a->edges, r, &from);
    case GRAZE_STRATUM_VERTEX:
        return draw_from(p, random_below(r, 2) ? &a->vertices : &a->edges, r, &from);
    case GRAZE_STRATUM_CROSSING:
        return draw_from(p, &a->faces, r, &from);
    case GRAZE_STRATUM_START:
    case GRAZE_STRATUM_END:
    case GRAZE_STRATUM_BREAK:
        choice = random_below(r, 4);
        return draw_from(p,
                         choice < 2    ? &a->faces
                         : choice == 2 ? &a->edges
                                       : &a->vertices,
                         r, &from);
    default:
        return 0;
    }
}

/* Find the surfaces through y on whose signs the solid near y depends. */
static graze_status find_dependence(touchpoint *p) {
    const csg *solid = p->g->atlas->solid;
    int d = solid->dimension;
    ZEROED(expression, e);
    LOCAL_VEC(fmpz, x, d + 1);
    size_t count = 0;
    FREED(size_t, vanishing, NULL);
    TRY(MAKE_ARRAY(p->context, vanishing, solid->surface_count + 1, "%zu surfaces",
                   solid->surface_count));
    TRY(expression_init(&e, p->context, solid));
    _fmpq_vec_get_fmpz_vec_fmpz(x, x + d, p->y, d);
    for (size_t k = 0; k < solid->surface_count; k++) {
        e.sign[k] = (signed char)csg_surface_sign(&solid->surface[k], x, d);
        if (!e.sign[k])
            vanishing[count++] = k;
    }
    return expression_ask(&p->at, &e, vanishing, count);
}

/* Set the dimension of the cell of y: d - 1 on one surface with a gradient; 1 in E^3 where several
 * gradients span less than space, unless y is isolated; else 0. */
static void measure_cell(touchpoint *p) {
    const csg *solid = p->g->atlas->solid;
    int d = solid->dimension, apex = 0;
    if (p->at.count == 0)
        return;
    LOCAL(fmpq_mat, gradients, p->at.count, d);
    for (int k = 0; k < p->at.count; k++) {
        fmpq *row = fmpq_mat_entry(gradients, k, 0);
        surface_gradient(row, &solid->surface[p->at.surface[k]], p->y, d);
        apex |= vector_is_zero(row, d);
    }
    p->kind = 0;
    if (!apex && p->at.count == 1)
        p->kind = d - 1;
    else if (!apex && !p->isolated && d == 3 && fmpq_mat_rref(gradients, gradients) < 3)
        p->kind = 1;
}

/* Choose one of the surfaces and turn its tangent plane outwards. The outer side is found for the
 * first signs of the other surfaces under which the two sides of this one differ. */
static void choose_surface(touchpoint *p, random_stream *r) {
    int k = (int)random_below(r, (size_t)p->at.count), facing = 0;
    const csg *solid = p->g->atlas->solid;
    p->surface = p->at.surface[k];
    tangent_plane(p->form, &solid->surface[p->surface], p->y, solid->dimension);
    for (unsigned s = 0; s < 1u << p->at.count && !facing; s++)
        facing = pattern_has(&p->at.truth, s | 1u << k) - pattern_has(&p->at.truth, s & ~(1u << k));
    if (facing < 0)
        _fmpz_vec_neg(p->form, p->form, solid->dimension + 1);
}

/* Find the order of the contact with the surface. */
static graze_status order_of_contact(int *order, const touchpoint *p, const fmpq *world) {
    HELD(trajectory, c, p->when->dimension);
    LOCAL(fmpz_poly, f);
    trajectory_set(
        &c,
        motion_tracing(&p->g->scene->motion->piece[p->when->piece], p->g->scene->options.operation),
        world);
    TRY(pullback_surface(f, p->context, &c, &p->g->atlas->solid->surface[p->surface]));
    *order = order_of_root(f, p->when->u);
    return GRAZE_OK;
}

/* The sign of the difference: a contact's time minus the time of the instant. */
static graze_status compare_times(int *out, const touchpoint *p, graze_time *time) {
    HELD(algebraic, u);
    algebraic_set_rational(&u, p->when->u);
    *out = time->piece < p->when->piece ? -1 : 1;
    if (time->piece == p->when->piece)
        TRY(algebraic_compare(out, p->context, &time->u, &u));
    else if (time->piece + 1 == p->when->piece && fmpq_is_zero(p->when->u))
        *out = time_is_piece_end(time) ? 0 : -1;
    return GRAZE_OK;
}

/* The primitive that has the surface and is a cell of the contact; the number of primitives if
 * there is none. */
static size_t touched_primitive(const touchpoint *p, const contact *c) {
    const csg *solid = p->g->atlas->solid;
    for (size_t n = 0; n < solid->node_count; n++)
        for (size_t k = 0; k < solid->node[n].count && solid->node[n].operation == CSG_SIGN; k++)
            for (size_t at = 0; at < c->cell_count; at++)
                if (solid->operand[solid->node[n].first + k] == p->surface &&
                    c->cell[at].a == solid->node[n].primitive)
                    return c->cell[at].a;
    return solid->primitive_count;
}

/* Trace the point: does it have a contact with a primitive of the surface at the time of the draw,
 * and a decided answer? */
static graze_status confirm(int *made, sample *out, const touchpoint *p) {
    graze_trace trace;
    graze_status status = GRAZE_OK;
    *made = 0;
    TRY(classify_point(&trace, p->context, p->g->scene, (query_point){.rational = out->point},
                       TRACE_CONTACTS));
    int decided = trace.verdict.pmc != GRAZE_PMC_UNDECIDED;
    for (size_t k = 0; k < trace.contact_count && decided && !*made && !status; k++) {
        int from = 0, to = 0;
        const contact *c = &trace.contact[k];
        status = compare_times(&from, p, c->from);
        if (!status)
            status = compare_times(&to, p, c->to);
        if (status || from > 0 || to < 0)
            continue;
        out->made.cell = (graze_cell){.kind = GRAZE_CELL_PRIMITIVE, .a = touched_primitive(p, c)};
        *made = out->made.cell.a < p->g->atlas->solid->primitive_count;
    }
    out->undecided += trace.undecided && !*made;
    trace_clear(&trace);
    return status;
}

static graze_status finish_contact(int *made, sample *out, fmpq *normal, touchpoint *p,
                                   graze_stratum stratum) {
    fmpq_set(out->time, p->when->t);
    TRY(order_of_contact(&out->made.order, p, out->point));
    *made = stratum_takes_order(stratum, out->made.order);
    if (*made && normal) {
        instant_normal(normal, p->when, p->form);
        *made = !vector_is_zero(normal, p->when->dimension);
    }
    return *made ? confirm(made, out, p) : GRAZE_OK;
}

graze_status curved_contact(int *made, sample *out, fmpq *normal, graze_context *context,
                            const struct graze_generator *g, graze_stratum stratum,
                            random_stream *r) {
    HELD(touchpoint, p, context, g);
    *made = draw_touch(&p, stratum, r);
    if (*made) {
        LOCAL_VEC(fmpz, y, 4);
        _fmpq_vec_get_fmpz_vec_fmpz(y, y + p.when->dimension, p.y, p.when->dimension);
        int any = !g->representable || out->made.stratum == GRAZE_STRATUM_ROUNDED;
        *made = sample_place(out, p.when, y, !any) && (any || sample_is_kept(out, g));
    }
    if (*made) {
        TRY(find_dependence(&p));
        measure_cell(&p);
        *made = stratum >= GRAZE_STRATUM_START && stratum <= GRAZE_STRATUM_BREAK ? p.kind >= 0
                : stratum == GRAZE_STRATUM_EDGE                                  ? p.kind == 1
                : stratum == GRAZE_STRATUM_VERTEX                                ? p.kind == 0
                                                  : p.kind == g->atlas->solid->dimension - 1;
    }
    if (*made) {
        choose_surface(&p, r);
        TRY(finish_contact(made, out, normal, &p, stratum));
    }
    return context_poll(context);
}
