/* Sites: place, sides, germs of the facets, trace, role.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/contact/nearby.h"

#include "base/context/scope.h"
#include "base/number/vector.h"
#include "decide/verdict/verdict.h"

static void begin_site(graze_site *s, const graze_scene *scene, const fmpq_t t, const fmpq *y) {
    int d = scene->motion->dimension;
    memset(s, 0, sizeof *s);
    s->scene = scene;
    s->dimension = d;
    s->y = _fmpq_vec_init(2 * d + 2);
    s->world = s->y + d;
    s->side[0].u = s->world + d;
    s->side[1].u = s->world + d + 1;
    vector_set(s->y, y, d);
    fmpq_init(s->t);
    fmpq_set(s->t, t);
    fmpq_init(s->shift);
}

void site_clear(graze_site *s) {
    _fmpq_vec_clear(s->y, 2 * s->dimension + 2);
    fmpq_clear(s->t);
    fmpq_clear(s->shift);
    for (int k = 0; k < 2; k++)
        flow_clear(&s->side[k].flow);
    for (size_t k = 0; k < s->germ_count; k++) {
        fmpq_clear(s->germ[k].speed);
        fmpq_clear(s->germ[k].drift);
        fmpq_clear(s->germ[k].theta);
    }
    free(s->germ);
    trace_clear(&s->trace);
    time_destroy(s->itself);
    neighborhood_clear(&s->place);
}

graze_status site_to_body(fmpq *point, graze_context *context, const graze_scene *scene,
                          const fmpq_t t) {
    int d = scene->motion->dimension;
    LOCAL_VEC(fmpq, body, d * (d + 2) + 2);
    fmpq *map = body + d, *u = map + d * (d + 1);
    site_side side[2] = {{.u = u}, {.u = u + 1}};
    TRY(sides_find(side, context, scene->motion, t));
    const site_side *one = &side[!side[0].present];
    point_map_at(map, &scene->motion->piece[one->piece].inverse, one->u);
    affine_image(body, map, point, d);
    vector_set(point, body, d);
    return GRAZE_OK;
}

static void find_world(graze_site *s) {
    const site_side *side = &s->side[!s->side[0].present];
    LOCAL_VEC(fmpq, map, POINT_MAP_ENTRIES);
    point_map_at(map, &s->scene->motion->piece[side->piece].forward, side->u);
    affine_image(s->world, map, s->y, s->dimension);
}

/* Find the order of the zero at t of the pullback of a facet's plane, and the pullback's sign next
 * to t, by its derivatives at t. */
static void find_germ_order(site_germ *germ, const graze_site *s) {
    const site_side *side = &s->side[germ->side > 0];
    HELD(trajectory, path, s->dimension);
    LOCAL(fmpz_poly, f);
    LOCAL(fmpq, value);
    trajectory_set(&path, &s->scene->motion->piece[side->piece].inverse, s->world);
    trajectory_pullback(f, &path, s->place.facet[germ->facet].form);
    germ->order = fmpz_poly_is_zero(f) ? GRAZE_ORDER_VANISHES : 0;
    while (germ->order >= 0 && fmpq_is_zero(value)) {
        fmpz_poly_derivative(f, f);
        germ->order++;
        fmpz_poly_evaluate_fmpq(value, f, side->u);
    }
    germ->sign = fmpq_sgn(value);
    if (germ->side < 0 && germ->order % 2 == 1)
        germ->sign = -germ->sign;
}

static void fill_germ(site_germ *germ, const graze_site *s, size_t facet, int side) {
    const flow *f = sides_flow(s->side, side > 0);
    int d = s->dimension;
    const fmpz *normal = s->place.facet[facet].normal;
    germ->facet = facet;
    germ->side = side;
    fmpq_init(germ->speed);
    fmpq_init(germ->drift);
    fmpq_init(germ->theta);
    sides_speed(germ->speed, s->side, side > 0, normal, s->y);
    flow_along(germ->drift, normal, f->drift, s->y, d);
    flow_along(germ->theta, normal, f->bend, s->y, d);
    if (!fmpq_is_zero(germ->speed)) {
        germ->order = 1;
        germ->sign = -side * fmpq_sgn(germ->speed);
    } else if (!fmpq_is_zero(germ->theta)) {
        germ->order = 2;
        germ->sign = fmpq_sgn(germ->theta);
    } else {
        find_germ_order(germ, s);
    }
}

static graze_status find_germs(graze_site *s, graze_context *context) {
    TRY(MAKE_ARRAY(context, s->germ, 2 * s->place.count, "the facets at a point"));
    sides_add_flows(s->side, s->scene->motion);
    for (size_t j = 0; j < s->place.count; j++)
        for (int k = 0; k < 2; k++)
            if (s->side[k].present)
                fill_germ(&s->germ[s->germ_count++], s, j, k ? 1 : -1);
    return GRAZE_OK;
}

/* Set theta, order and orientation of the facts if they are defined (proofs/envelope.md C61, C62).
 */
static void find_slice(graze_site *s) {
    const site_germ *germ = &s->germ[0];
    graze_site_facts *f = &s->facts;
    f->on_slice = s->place.kind == PLACE_FACET && !s->is_break && fmpq_is_zero(germ->speed);
    if (!f->on_slice)
        return;
    int turn = sides_flow(s->side, germ->side > 0)->orientation * -fmpq_sgn(germ->drift) *
               fmpq_sgn(germ->theta);
    f->theta = fmpq_sgn(germ->theta);
    f->order = germ->order;
    f->orientation = turn > 0   ? GRAZE_ORIENTATION_PRESERVING
                     : turn < 0 ? GRAZE_ORIENTATION_REVERSING
                                : GRAZE_ORIENTATION_DEGENERATE;
}

/* The state on a side of t by the pullbacks' signs, for a cone of a kind but PLACE_OTHER; ABSENT
 * beyond an end of the motion.
 */
static graze_state state_by_signs(const graze_site *s, int side) {
    int outside = 0, inside = 0, count = 0, reflex = s->place.kind == PLACE_REFLEX;
    for (size_t k = 0; k < s->germ_count; k++)
        if (s->germ[k].side == side) {
            outside += s->germ[k].sign > 0;
            inside += s->germ[k].sign < 0;
            count++;
        }
    if (count == 0)
        return GRAZE_STATE_ABSENT;
    if (reflex)
        return inside ? GRAZE_STATE_I : outside == count ? GRAZE_STATE_O : GRAZE_STATE_B;
    return outside ? GRAZE_STATE_O : inside == count ? GRAZE_STATE_I : GRAZE_STATE_B;
}

/* Check that the trace and the germs agree on the states beside t. */
static graze_status check_states(const graze_site *s, graze_context *context) {
    if (s->place.kind == PLACE_OTHER ||
        (state_by_signs(s, -1) == s->facts.left && state_by_signs(s, 1) == s->facts.right))
        return GRAZE_OK;
    return context_fail(context, GRAZE_EINTERNAL,
                        "the facets at a point and its trace disagree on the states beside a time");
}

/* Find the sides, the place, the point in the world and the germs. */
static graze_status begin_facts(graze_site *s, graze_context *context) {
    TRY(sides_find(s->side, context, s->scene->motion, s->t));
    TRY(neighborhood_locate(&s->place, context, s->scene->solid, s->y));
    if (!s->place.count)
        return context_fail(context, GRAZE_EINPUT,
                            "the point is not on the boundary of the solid; expected one that is");
    s->is_break = sides_break(s->side, s->scene->motion);
    find_world(s);
    s->facts.cell = s->place.cell;
    return find_germs(s, context);
}

static graze_status fill_site(graze_site *s, graze_context *context, site_question asked) {
    TRY(begin_facts(s, context));
    if (asked != SITE_ROLE) {
        TRY(classify_point(&s->trace, context, s->scene, (query_point){.rational = s->world},
                           TRACE_CONTACTS));
        TRY((asked == SITE_ALL ? nearest_find : nearest_trim)(s, context));
        TRY(check_states(s, context));
    }
    if (asked != SITE_TRIM)
        TRY(role_decide(&s->facts.role, context, s));
    find_slice(s);
    return GRAZE_OK;
}

graze_status site_make_for(graze_site *out, graze_context *context, const graze_scene *scene,
                           const fmpq_t t, const fmpq *y, site_question asked) {
    begin_site(out, scene, t, y);
    graze_status status = fill_site(out, context, asked);
    if (status)
        site_clear(out);
    return status;
}

graze_status site_make(graze_site *out, graze_context *context, const graze_scene *scene,
                       const fmpq_t t, const fmpq *y) {
    return site_make_for(out, context, scene, t, y, SITE_ALL);
}

/* Make the site of a cell that has no contact at t, with the given point. */
static graze_status make_missed(graze_site *out, graze_context *context, const graze_scene *scene,
                                const fmpq_t t, const fmpq *y, const graze_cell *cell) {
    begin_site(out, scene, t, y);
    graze_status status = sides_find(out->side, context, scene->motion, t);
    if (status) {
        site_clear(out);
        return status;
    }
    find_world(out);
    out->facts.cell = *cell;
    out->snapped = out->missed = 1;
    return GRAZE_OK;
}

graze_status site_snap(graze_site *out, graze_context *context, const graze_scene *scene,
                       const fmpq_t t, const fmpq *y, const graze_cell *cell) {
    HELD(nearby, n, y, scene->motion->dimension);
    TRY(snap_find(&n, context, scene, t, cell));
    if (!n.found)
        return make_missed(out, context, scene, t, y, cell);
    TRY(site_make(out, context, scene, t, n.point));
    if (cell->kind == GRAZE_CELL_VERTEX && out->facts.role != GRAZE_ROLE_CONTACT) {
        site_clear(out);
        return make_missed(out, context, scene, t, y, cell);
    }
    fmpq_swap(out->shift, n.square);
    out->snapped = 1;
    return GRAZE_OK;
}
