/* Germs of contacts. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The times at which the trajectory's cell changes, each with its cone and its two sides, and one
 * time in each stretch between them during which it stays on the boundary.
 */
#include "topo/germs.h"

#include <flint/fmpq_poly.h>
#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include <flint/fmpz_poly_factor.h>
#include <stdlib.h>
#include <string.h>
#include "context/array.h"
#include "number/order.h"
#include "trace/candidates.h"
#include "trace/touch.h"

/* Larger ones are not factored to look for rational roots. */
enum { FACTORED_DEGREE = 60 };

void germs_init(germ_list *list) {
    memset(list, 0, sizeof *list);
    list->bounded = 1;
    list->reason = "";
}

void germs_clear(germ_list *list) {
    for (size_t k = 0; k < list->count; k++) {
        germ *g = &list->item[k];
        cone_clear(&g->cone);
        for (int i = 0; i < 9; i++)
            fmpz_clear(g->to_body + i);
        for (int i = 0; i < 6; i++)
            fmpz_clear(g->side[i / 3].e + i % 3);
    }
    free(list->item);
}

static void leave_open(germ_list *list, const char *reason) {
    list->bounded = 0;
    list->reason = reason;
}

/* One piece of the motion. */
typedef struct germ_maker {
    germ_list *list;
    graze_context *context;
    const graze_scene *scene;
    const plane_list *planes;
    const point_map *map;
    trajectory path;
    int keeps_directions; /* the linear part is a constant matrix times a function */
} germ_maker;

/* All entries of the linear part are multiples of one polynomial. */
static int map_keeps_directions(const point_map *map) {
    int d = map->dimension, same = 1;
    const fmpz_poly_struct *first = NULL;
    for (int i = 0; i < d * (d + 1); i++) {
        const fmpz_poly_struct *entry = &map->entry[i];
        if (i % (d + 1) == d || fmpz_poly_is_zero(entry))
            continue;
        first = first ? first : entry;
        fmpz_poly_t a, b;
        fmpz_poly_init(a);
        fmpz_poly_init(b);
        fmpz_poly_scalar_mul_fmpz(a, entry, fmpz_poly_lead(first));
        fmpz_poly_scalar_mul_fmpz(b, first, fmpz_poly_lead(entry));
        same = same && fmpz_poly_equal(a, b);
        fmpz_poly_clear(a);
        fmpz_poly_clear(b);
    }
    return same;
}

/* Integers in the ratio of n rationals. */
static void integers_of(fmpz *out, const fmpq *x, slong n) {
    fmpz_t common;
    fmpz_init(common);
    _fmpq_vec_get_fmpz_vec_fmpz(out, common, x, n);
    _fmpz_vec_content(common, out, n);
    if (!fmpz_is_zero(common))
        _fmpz_vec_scalar_divexact_fmpz(out, out, n, common);
    fmpz_clear(common);
}

/* The linear part of the inverse map at a time; its positive weight is left out. */
static void set_to_body(germ *g, const germ_maker *m, const fmpq_t u) {
    int d = m->map->dimension;
    fmpq *entry = _fmpq_vec_init(d * d);
    for (int i = 0; i < d * d; i++)
        fmpz_poly_evaluate_fmpq(entry + i, &m->map->entry[i / d * (d + 1) + i % d], u);
    integers_of(g->to_body, entry, d * d);
    _fmpq_vec_clear(entry, d * d);
}

/* Way of the trajectory from its place x at time u, times a positive function, in powers of the
 * time that has passed. */
static void ways_from(fmpq_poly_t *way, const germ_maker *m, const fmpz *x, const fmpq_t u) {
    int d = m->path.dimension;
    fmpz_poly_t p;
    fmpq_poly_t later;
    fmpz_poly_init(p);
    fmpq_poly_init(later);
    fmpq_poly_set_coeff_fmpq(later, 0, u);
    fmpq_poly_set_coeff_si(later, 1, 1);
    for (int i = 0; i < d; i++) {
        fmpz_poly_scalar_mul_fmpz(p, &m->path.x[i], x + d);
        fmpz_poly_scalar_submul_fmpz(p, &m->path.x[d], x + i);
        fmpq_poly_set_fmpz_poly(way[i], p);
        fmpq_poly_compose(way[i], way[i], later);
    }
    fmpz_poly_clear(p);
    fmpq_poly_clear(later);
}

static void coefficients_at(fmpz *out, fmpq_poly_t *way, slong k, int d) {
    fmpq *c = _fmpq_vec_init(d);
    for (int i = 0; i < d; i++)
        fmpq_poly_get_coeff_fmpq(c + i, way[i], k);
    integers_of(out, c, d);
    _fmpq_vec_clear(c, d);
}

/* Is the vector modulo the directions of the cell 0, or a multiple of e? */
static int is_along(const local_cone *cone, const fmpz *v, const fmpz *e) {
    slong d = cone->dimension;
    int along = 1;
    fmpz_t a, b, c, f;
    fmpz_init(a);
    fmpz_init(b);
    fmpz_init(c);
    fmpz_init(f);
    for (size_t i = 0; i < cone->count && along; i++)
        for (size_t j = 0; j <= i && along; j++) {
            _fmpz_vec_dot(a, cone->normal + i * (size_t)d, v, d);
            _fmpz_vec_dot(b, cone->normal + j * (size_t)d, e, d);
            _fmpz_vec_dot(c, cone->normal + j * (size_t)d, v, d);
            _fmpz_vec_dot(f, cone->normal + i * (size_t)d, e, d);
            fmpz_mul(a, a, b);
            fmpz_submul(a, c, f);
            along = fmpz_is_zero(a);
        }
    fmpz_clear(a);
    fmpz_clear(b);
    fmpz_clear(c);
    fmpz_clear(f);
    return along;
}

/* 1 if the vector lies in the cell's directions; else *planes counts the planes it is parallel to.
 */
static int is_in_cell(size_t *planes, const local_cone *cone, const fmpz *v) {
    slong d = cone->dimension;
    fmpz_t a;
    fmpz_init(a);
    *planes = 0;
    for (size_t j = 0; j < cone->count; j++) {
        _fmpz_vec_dot(a, cone->normal + j * (size_t)d, v, d);
        *planes += fmpz_is_zero(a) != 0;
    }
    fmpz_clear(a);
    return *planes == cone->count;
}

/* A leading direction along an edge that leaves a vertex is not enough to know what is covered,
 * unless the way is straight (proofs/topology.md C46). */
static graze_status check_edge_ray(germ_maker *m, local_cone *cone, const germ_side *side,
                                   size_t planes) {
    graze_state state = GRAZE_STATE_O;
    graze_status status = GRAZE_OK;
    if (planes >= 2 && !side->straight)
        status = cone_state(&state, cone, m->context, side->e);
    if (state != GRAZE_STATE_O)
        leave_open(m->list, "a trajectory leaves a vertex along an edge and bends");
    return status;
}

/* The side after (sign 1) or before (-1) the germ's time. */
static graze_status add_side(germ_maker *m, germ *g, fmpq_poly_t *way, int sign) {
    int d = m->path.dimension;
    slong length = 0, order = 0;
    size_t planes = 0;
    germ_side *side = &g->side[g->side_count];
    for (int i = 0; i < d; i++)
        length = FLINT_MAX(length, fmpq_poly_length(way[i]));
    for (slong k = 1; k < length && !order; k++) {
        coefficients_at(side->e, way, k, d);
        order = is_in_cell(&planes, &g->cone, side->e) ? 0 : k;
    }
    if (!order)
        return GRAZE_OK;
    side->straight = m->keeps_directions;
    fmpz *later = _fmpz_vec_init(d);
    for (slong k = order + 1; k < length && side->straight; k++) {
        coefficients_at(later, way, k, d);
        side->straight = is_along(&g->cone, later, side->e);
    }
    _fmpz_vec_clear(later, d);
    if (sign < 0 && order % 2 == 1)
        _fmpz_vec_neg(side->e, side->e, d);
    g->side_count++;
    return check_edge_ray(m, &g->cone, side, planes);
}

/* A germ at a rational time, with its sides inside [0, 1]. */
static graze_status add_germ(germ_maker *m, const fmpq_t u) {
    int d = m->path.dimension;
    germ_list *list = m->list;
    graze_status status = array_grow(m->context, &list->item, &list->capacity, list->count + 1,
                                     sizeof *list->item, "the contacts of a point");
    if (status)
        return status;
    germ *g = &list->item[list->count++];
    memset(g, 0, sizeof *g);
    fmpz *x = _fmpz_vec_init(d + 1);
    fmpq_poly_t way[3];
    for (int i = 0; i < d; i++)
        fmpq_poly_init(way[i]);
    trajectory_at(x, &m->path, u);
    set_to_body(g, m, u);
    status = cone_make(&g->cone, m->context, m->scene->solid, m->planes, x);
    ways_from(way, m, x, u);
    if (!status && !fmpq_is_one(u))
        status = add_side(m, g, way, 1);
    if (!status && !fmpq_is_zero(u))
        status = add_side(m, g, way, -1);
    for (int i = 0; i < d; i++)
        fmpq_poly_clear(way[i]);
    _fmpz_vec_clear(x, d + 1);
    return status;
}

/* 1 and the value if a number is rational. */
static int rational_of(fmpq_t out, const algebraic *x) {
    int found = algebraic_is_rational(x);
    if (found)
        fmpq_set(out, x->value);
    if (found || fmpz_poly_degree(x->poly) > FACTORED_DEGREE)
        return found;
    fmpz_poly_factor_t factors;
    fmpz_poly_factor_init(factors);
    fmpz_poly_factor(factors, x->poly);
    for (slong k = 0; k < factors->num && !found; k++) {
        if (fmpz_poly_degree(factors->p + k) != 1)
            continue;
        fmpz_t c;
        fmpz_init(c);
        fmpz_neg(c, fmpz_poly_get_coeff_ptr(factors->p + k, 0));
        fmpq_set_fmpz_frac(out, c, fmpz_poly_lead(factors->p + k));
        fmpz_clear(c);
        found = dyadic_compare(x->where.low, x->where.exponent, out) < 0 &&
                dyadic_compare(x->where.high, x->where.exponent, out) > 0;
    }
    fmpz_poly_factor_clear(factors);
    return found;
}

static graze_status add_germ_at(germ_maker *m, const algebraic *time) {
    graze_status status = GRAZE_OK;
    fmpq_t u;
    fmpq_init(u);
    if (rational_of(u, time))
        status = add_germ(m, u);
    else
        leave_open(m->list, "a contact is at an irrational time");
    fmpq_clear(u);
    return status;
}

/* A stretch between two neighbouring times, in one cell. */
static graze_status add_stretch(germ_maker *m, algebraic *from, algebraic *to) {
    fmpq_t u;
    fmpq_init(u);
    graze_status status = algebraic_between(u, m->context, from, to);
    if (!status)
        status = add_germ(m, u);
    if (!m->keeps_directions)
        leave_open(m->list, "the solid turns while it slides along the point");
    fmpq_clear(u);
    return status;
}

/* Does a touch last from one rank to another? */
static int is_touched(const touches *t, size_t from, size_t to) {
    for (size_t k = 0; k < t->count; k++)
        if (t->item[k].from <= from && t->item[k].to >= to)
            return 1;
    return 0;
}

/* Ranks are those of touches_order. */
static graze_status add_touches(germ_maker *m, const touches *t) {
    size_t ranks = 0;
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < t->count; k++)
        ranks = t->item[k].to >= ranks ? t->item[k].to + 1 : ranks;
    for (size_t r = 0; r < ranks && !status; r++) {
        algebraic *time = &t->time.item[t->by_rank[r]];
        if (is_touched(t, r, r))
            status = add_germ_at(m, time);
        if (!status && is_touched(t, r, r + 1))
            status = add_stretch(m, time, &t->time.item[t->by_rank[r + 1]]);
    }
    return status;
}

static graze_status add_contacts_of_piece(germ_maker *m) {
    candidates near = {0, 0, NULL};
    touches t;
    touches_init(&t);
    graze_status status = candidates_find(&near, m->context, m->scene->solid, &m->path);
    if (!status)
        status = touches_find(&t, m->context, m->scene->solid, &m->path, &near);
    if (!status)
        status = touches_order(&t, m->context);
    if (!status)
        status = add_touches(m, &t);
    touches_clear(&t);
    free(near.item);
    return status;
}

graze_status germs_find(germ_list *list, graze_context *context, const graze_scene *scene,
                        const plane_list *planes, const fmpq *point) {
    germ_maker m = {.list = list, .context = context, .scene = scene, .planes = planes};
    graze_status status = GRAZE_OK;
    trajectory_init(&m.path, scene->motion->dimension);
    for (size_t k = 0; k < scene->motion->piece_count && !status; k++) {
        m.map = motion_tracing(&scene->motion->piece[k], scene->options.operation);
        m.keeps_directions = map_keeps_directions(m.map);
        trajectory_set(&m.path, m.map, point);
        status = add_contacts_of_piece(&m);
    }
    trajectory_clear(&m.path);
    return status;
}

static graze_status cover_by_germ(germ_cover *out, germ *g, graze_context *context,
                                  const fmpz *direction) {
    slong d = g->cone.dimension;
    graze_state state = GRAZE_STATE_O;
    fmpz *u = _fmpz_vec_init(d);
    for (int i = 0; i < d; i++)
        _fmpz_vec_dot(u + i, g->to_body + i * d, direction, d);
    graze_status status = cone_state(&state, &g->cone, context, u);
    out->open |= state == GRAZE_STATE_I;
    out->exact |= state != GRAZE_STATE_O;
    for (int s = 0; s < g->side_count && !status; s++) {
        int in_interior = 0, in_cone = 0;
        status = cone_sweep(&in_interior, &in_cone, &g->cone, context, u, g->side[s].e);
        out->open |= in_interior;
        out->covered |= in_cone;
        out->exact |= in_cone && g->side[s].straight;
    }
    out->covered |= out->exact | out->open;
    _fmpz_vec_clear(u, d);
    return status;
}

graze_status germs_cover(germ_cover *out, germ_list *list, graze_context *context,
                         const fmpz *direction) {
    graze_status status = GRAZE_OK;
    *out = (germ_cover){0, 0, 0};
    for (size_t k = 0; k < list->count && !status && !(out->open && out->exact); k++)
        status = cover_by_germ(out, &list->item[k], context, direction);
    return status;
}
