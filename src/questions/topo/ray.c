/* The facets that places of a ray can meet, as functions affine in the ray's parameter s.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A form at the place s of the ray, at time u, is at(u) + s slope(u). The facets that the place's
 * trajectory meets can change with s only at certain u: where a facet's form has a double root,
 * where it vanishes together with a side form, and at the ends of a piece. These u are finitely
 * many and do not depend on s. At each such u the form vanishes for s = -at / slope, and `reach` is
 * kept below all such s > 0 (proofs/closure.md C74).
 */
#include <math.h>
#include "base/context/scope.h"
#include "base/number/isolate.h"
#include "questions/topo/near.h"

/* A solid with more than FEW_FACETS facets is given a first reach that is 2^-NEARER_PLACES times as
 * large. */
enum { FEW_FACETS = 200, NEARER_PLACES = 10, FORMS = 4, PARTS = 5 };

/* A form along the ray, at + s slope: these two polynomials in time, their common factor, and both
 * divided by the factor. */
typedef struct ray_form {
    fmpz_poly_struct *at, *slope, *common, *plain_at, *plain_slope;
} ray_form;

typedef struct ray_maker {
    graze_context *context;
    const graze_scene *scene;
    const point_map *map; /* of the piece */
    trajectory *path;
    fmpz *place;     /* the point: d + 1 homogeneous integers */
    fmpz *direction; /* d integers, over the last entry of `place` */
    fmpq *reach;
    ulong places; /* halvings of the first reach so far */
    int special;
} ray_maker;

static void ray_form_set(ray_form *f, const ray_maker *m, const fmpz *form) {
    trajectory_pullback(f->at, m->path, form);
    signs_pull_back(f->slope, m->map, form, m->direction);
    fmpz_poly_gcd(f->common, f->at, f->slope);
    fmpz_poly_zero(f->plain_at);
    fmpz_poly_zero(f->plain_slope);
    if (fmpz_poly_is_zero(f->common))
        return;
    fmpz_poly_div(f->plain_at, f->at, f->common);
    fmpz_poly_div(f->plain_slope, f->slope, f->common);
}

/* Is -at / slope independent of time? */
static int is_steady(const ray_form *f) {
    return fmpz_poly_length(f->plain_at) <= 1 && fmpz_poly_length(f->plain_slope) <= 1;
}

/* Keep `reach` below the s > 0 at which the form vanishes at a time, if there is one: for smaller s
 * the form has the same sign as at s = 0. */
static graze_status stay_below(ray_maker *m, const ray_form *f, algebraic *time) {
    int sign = 0, slope = 0, there = 0;
    LOCAL(fmpz_poly, p);
    TRY(algebraic_sign_at(&sign, m->context, f->plain_at, time));
    TRY(algebraic_sign_at(&slope, m->context, f->plain_slope, time));
    while (sign * slope < 0 && there != sign && !m->special) {
        fmpz_poly_scalar_mul_fmpz(p, f->plain_at, fmpq_denref(m->reach));
        fmpz_poly_scalar_addmul_fmpz(p, f->plain_slope, fmpq_numref(m->reach));
        TRY(algebraic_sign_at(&there, m->context, p, time));
        if (there == sign)
            break;
        ulong step = 1 + m->places / 8;
        fmpq_div_2exp(m->reach, m->reach, step);
        m->places += step;
        m->special = m->places > m->context->limits[GRAZE_LIMIT_BITS];
    }
    return GRAZE_OK;
}

static graze_status stay_below_all(ray_maker *m, const ray_form *form, algebraic *time) {
    for (int k = 0; k <= m->path->dimension; k++)
        TRY(stay_below(m, form + k, time));
    return GRAZE_OK;
}

/* Keep `reach` below the zeros of all forms at the roots of a polynomial in a window of time. */
static graze_status stay_below_at_roots(ray_maker *m, const ray_form *form, const fmpz_poly_t p,
                                        const dyadic_interval *window) {
    if (fmpz_poly_degree(p) < 1)
        return GRAZE_OK;
    HELD(algebraic_list, roots);
    TRY(algebraic_roots(&roots, m->context, p, window));
    for (size_t k = 0; k < roots.count && !m->special; k++)
        TRY(stay_below_all(m, form, &roots.item[k]));
    return GRAZE_OK;
}

/* Keep `reach` below places whose trajectories meet the plane at a double root, or at a root that
 * does not depend on s. */
static graze_status stay_below_plane(ray_maker *m, const ray_form *form,
                                     const dyadic_interval *window) {
    LOCAL(fmpz_poly, p);
    HELD(algebraic, any);
    if (is_steady(form)) {
        TRY(stay_below(m, form, &any));
        fmpz_poly_set(p, form->common);
    } else {
        wronskian(p, form->slope, form->at);
    }
    return stay_below_at_roots(m, form, p, window);
}

/* Keep `reach` below places at which the plane's form and a side form vanish at the same time. */
static graze_status stay_below_side(ray_maker *m, const ray_form *form, int side,
                                    const dyadic_interval *window) {
    LOCAL(fmpz_poly, p);
    cross_terms(p, form->at, form->slope, form[side].at, form[side].slope);
    m->special = m->special || (fmpz_poly_is_zero(p) && !is_steady(form));
    return stay_below_at_roots(m, form, p, window);
}

/* Keep `reach` below places at which a form vanishes at an end of the piece in the window. */
static graze_status stay_below_at_ends(ray_maker *m, const ray_form *form, const candidate *near) {
    HELD(algebraic, end);
    for (slong k = 0; k < 2; k++) {
        algebraic_set_dyadic(&end, &(fmpz){k}, 0);
        if (k ? near->to == UINT32_C(1) << WINDOW_LEVELS : near->from == 0)
            TRY(stay_below_all(m, form, &end));
    }
    return GRAZE_OK;
}

/* Keep `reach` below the events of one simplex that the ray can meet in a window of time. */
static graze_status stay_below_simplex(ray_maker *m, const candidate *near) {
    int d = m->path->dimension;
    LOCAL_VEC(fmpz, form, 2 * (d + 1));
    fmpz *side = form + d + 1;
    LOCAL_VEC(fmpz_poly, part, FORMS * PARTS);
    ray_form f[FORMS] = {{.at = NULL}};
    HELD(dyadic_interval, window);
    fmpz_set_ui(window.low, near->from);
    fmpz_set_ui(window.high, near->to);
    window.exponent = WINDOW_LEVELS;
    (void)solid_plane(form, m->scene->solid, near->simplex);
    for (int k = 0; k <= d; k++) {
        fmpz_poly_struct *p = part + PARTS * k;
        f[k] = (ray_form){p, p + 1, p + 2, p + 3, p + 4};
        if (k > 0)
            solid_side(side, m->scene->solid, near->simplex, form, k - 1);
        ray_form_set(&f[k], m, k > 0 ? side : form);
    }
    m->special = m->special || fmpz_poly_is_zero(f[0].common);
    if (!m->special)
        TRY(stay_below_at_ends(m, f, near));
    if (!m->special)
        TRY(stay_below_plane(m, f, &window));
    for (int k = 1; k <= d && !m->special; k++)
        TRY(stay_below_side(m, f, k, &window));
    return context_poll(m->context);
}

/* Keep `reach` below the events of a piece. The trajectories of all places up to the current reach
 * lie between those of P and of the last place. */
static graze_status stay_below_piece(ray_maker *m) {
    int d = m->path->dimension;
    ZEROED(candidates, near);
    LOCAL_VEC(fmpz, end, d + 1);
    _fmpz_vec_scalar_mul_fmpz(end, m->place, d + 1, fmpq_denref(m->reach));
    _fmpz_vec_scalar_addmul_fmpz(end, m->direction, d, fmpq_numref(m->reach));
    HELD(trajectory, far, d);
    trajectory_carry(m->path, m->map, m->place);
    trajectory_carry(&far, m->map, end);
    TRY(candidates_find_between(&near, m->context, m->scene->solid, m->path, &far));
    for (size_t k = 0; k < near.count && !m->special; k++)
        TRY(stay_below_simplex(m, &near.item[k]));
    return GRAZE_OK;
}

/* Set the first reach so that the ray up to it is about as long as the solid is wide, or shorter if
 * there are many facets. */
static void set_first_reach(fmpq_t reach, const graze_solid *solid, const fmpz *direction,
                            slong d) {
    int exponent = 0;
    double width = box_extent(&solid->boxes.node[0].box);
    (void)frexp(isfinite(width) ? width : 1, &exponent);
    slong places = FLINT_ABS(_fmpz_vec_max_bits(direction, d)) - exponent;
    places += solid->cut.count > FEW_FACETS ? NEARER_PLACES : 0;
    fmpq_one(reach);
    rational_shift(reach, -places);
}

graze_status ray_find_reach(int *found, fmpq_t reach, graze_context *context,
                            const graze_scene *scene, const fmpq *point, const fmpz *direction) {
    const graze_motion *motion = scene->motion;
    slong d = motion->dimension;
    LOCAL_VEC(fmpz, place, 2 * d + 1);
    HELD(trajectory, path, (int)d);
    ray_maker m = {.context = context,
                   .scene = scene,
                   .path = &path,
                   .place = place,
                   .direction = place + d + 1,
                   .reach = reach};
    _fmpq_vec_get_fmpz_vec_fmpz(place, place + d, point, d);
    _fmpz_vec_scalar_mul_fmpz(m.direction, direction, d, place + d);
    set_first_reach(reach, scene->solid, direction, d);
    for (size_t k = 0; k < motion->piece_count && !m.special; k++) {
        m.map = motion_tracing(&motion->piece[k], scene->options.operation);
        TRY(stay_below_piece(&m));
    }
    *found = !m.special;
    return GRAZE_OK;
}
