/* The germs of a trajectory's contacts.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A germ is made at each time at which the trajectory changes its boundary cell, and at one time in
 * each interval between these that the trajectory spends on the boundary; at two more if the solid
 * turns during the interval.
 */
#include "questions/topo/eliminate.h"

#include "base/context/array.h"
#include "base/context/scope.h"

void germ_list_init(germ_list *list) {
    memset(list, 0, sizeof *list);
    list->bounded = 1;
    list->reason = "";
}

static void clear_germ(germ *g) {
    cone_clear(&g->cone);
    germ_drop_root(g);
    if (g->has_time)
        fmpq_clear(&g->time);
    _fmpz_vec_zero(g->to_body, 9);
    for (int k = 0; k < 2; k++) {
        _fmpz_vec_zero(g->side[k].e, 3);
        _fmpz_vec_zero(g->side[k].later, 3);
    }
}

void germ_list_clear(germ_list *list) {
    for (size_t k = 0; k < list->count; k++)
        clear_germ(&list->item[k]);
    for (size_t k = 0; k < list->turn_count; k++) {
        algebraic_clear(&list->turn[k].from);
        algebraic_clear(&list->turn[k].to);
    }
    free(list->item);
    free(list->turn);
}

/* Append a germ with the map of its piece; its other members are zeros. */
static graze_status germs_append(germ **out, germ_list *list, graze_context *context,
                                 const point_map *map) {
    TRY(LIST_GROW(context, list, "the contacts of a point"));
    *out = &list->item[list->count++];
    memset(*out, 0, sizeof **out);
    (*out)->map = map;
    return GRAZE_OK;
}

/* Append a turning stretch between two times; the list's last germ is at a time inside it. */
static graze_status germs_append_turn(germ_list *list, graze_context *context,
                                      const algebraic *from, const algebraic *to) {
    TRY(ARRAY_GROW(context, list->turn, list->turn_capacity, list->turn_count + 1,
                   "the times in which the solid turns"));
    turning_stretch *t = &list->turn[list->turn_count++];
    t->germ = list->count - 1;
    algebraic_init(&t->from);
    algebraic_init(&t->to);
    algebraic_set(&t->from, from);
    algebraic_set(&t->to, to);
    return GRAZE_OK;
}

/* Clear `bounded`, as germs are missing, and keep the reason, a static text. */
static void germs_leave_open(germ_list *list, const char *reason) {
    list->bounded = 0;
    list->reason = reason;
}

/* State of making the germs of one piece of the motion. */
typedef struct germ_maker {
    germ_list *list;
    const graze_scene *scene;
    germ_place at;
} germ_maker;

/* Set `to_body` to the linear part of the tracing map at a time, up to a positive factor. */
static void set_to_body(germ *g, const germ_maker *m, const fmpq_t u) {
    int d = m->at.map->dimension;
    LOCAL_VEC(fmpq, entry, d * d);
    for (int i = 0; i < d * d; i++)
        fmpz_poly_evaluate_fmpq(entry + i, &m->at.map->entry[i / d * (d + 1) + i % d], u);
    direction_of_rationals(g->to_body, entry, d * d);
}

/* The displacement of the trajectory from its place x at time u, times a positive function, in
 * powers of the time since u. */
static void ways_from(fmpq_poly_struct *way, const germ_maker *m, const fmpz *x, const fmpq_t u) {
    int d = m->at.path->dimension;
    LOCAL(fmpz_poly, p);
    LOCAL(fmpq_poly, later);
    fmpq_poly_set_coeff_fmpq(later, 0, u);
    fmpq_poly_set_coeff_si(later, 1, 1);
    for (int i = 0; i < d; i++) {
        fmpz_poly_scalar_mul_fmpz(p, &m->at.path->x[i], x + d);
        fmpz_poly_scalar_submul_fmpz(p, &m->at.path->x[d], x + i);
        fmpq_poly_set_fmpz_poly(way + i, p);
        fmpq_poly_compose(way + i, way + i, later);
    }
}

/* Add the sides of a germ that are inside the piece, [0, 1], and set `exact`. */
static graze_status add_sides(germ_maker *m, germ *g, const fmpz *x, const fmpq_t u) {
    int same_way = 0;
    LOCAL_VEC(fmpq_poly, way, 3);
    ways_from(way, m, x, u);
    g->exact = planes_keep_directions(&same_way, &g->cone, m->at.map, m->at.path);
    if (!fmpq_is_one(u))
        TRY(sides_add(g, m->at.context, m->at.map, way, same_way, 1));
    if (!fmpq_is_zero(u))
        TRY(sides_add(g, m->at.context, m->at.map, way, same_way, -1));
    return GRAZE_OK;
}

/* Append a germ at a rational time. */
static graze_status add_germ(germ_maker *m, const fmpq_t u) {
    int d = m->at.path->dimension;
    germ *g = NULL;
    TRY(germs_append(&g, m->list, m->at.context, m->at.map));
    LOCAL_VEC(fmpz, x, d + 1);
    g->has_time = 1;
    fmpq_init(&g->time);
    fmpq_set(&g->time, u);
    trajectory_at(x, m->at.path, u);
    set_to_body(g, m, u);
    TRY(cone_make(&g->cone, m->at.context, m->at.solid, m->at.outside, m->at.planes, x));
    return add_sides(m, g, x, u);
}

/* Append a germ at an irrational time. */
static graze_status add_root(germ_maker *m, const algebraic *time, const fmpz_poly_t minimal) {
    germ *g = NULL;
    int found = 0;
    TRY(germs_append(&g, m->list, m->at.context, m->at.map));
    TRY(root_set_germ(&found, g, &m->at, time, minimal));
    if (!found) {
        clear_germ(&m->list->item[--m->list->count]);
        germs_leave_open(m->list, "a contact at an irrational time is not looked at");
    }
    return GRAZE_OK;
}

/* Append a germ at any time; at an algebraic number of a high degree the cover remains unknown. */
static graze_status add_germ_at(germ_maker *m, const algebraic *time) {
    LOCAL(fmpq, u);
    LOCAL(fmpz_poly, minimal);
    if (algebraic_is_rational(time))
        TRY(add_germ(m, time->value));
    else if (!root_find_minimal(minimal, time))
        germs_leave_open(m->list, "a contact is at an irrational time of a high degree");
    else if (root_is_rational(u, minimal))
        TRY(add_germ(m, u));
    else
        TRY(add_root(m, time, minimal));
    return GRAZE_OK;
}

/* Append a germ at a rational time between two times, and give it as `u`. */
static graze_status add_germ_between(fmpq_t u, germ_maker *m, algebraic *from, algebraic *to) {
    TRY(algebraic_between(u, m->at.context, from, to));
    return add_germ(m, u);
}

/* Append a turning stretch, with the last germ at u inside it, and two more germs in it. */
static graze_status add_turn(germ_maker *m, const fmpq_t u, algebraic *from, algebraic *to) {
    LOCAL(fmpq, v);
    HELD(algebraic, middle);
    algebraic_set_rational(&middle, u);
    TRY(germs_append_turn(m->list, m->at.context, from, to));
    TRY(add_germ_between(v, m, from, &middle));
    return add_germ_between(v, m, &middle, to);
}

/* Add the germs of an interval between two successive times, in which the cell does not change. */
static graze_status add_stretch(germ_maker *m, algebraic *from, algebraic *to) {
    LOCAL(fmpq, u);
    TRY(add_germ_between(u, m, from, to));
    if (!m->list->item[m->list->count - 1].exact)
        TRY(add_turn(m, u, from, to));
    return GRAZE_OK;
}

/* Does some touch contain all times from one rank to another? */
static int is_touched(const touches *t, size_t from, size_t to) {
    for (size_t k = 0; k < t->count; k++)
        if (t->item[k].from <= from && t->item[k].to >= to)
            return 1;
    return 0;
}

/* Add the germs of all touches; touches_order has given their ends ranks. */
static graze_status add_touches(germ_maker *m, const touches *t) {
    size_t ranks = 0;
    for (size_t k = 0; k < t->count; k++)
        ranks = t->item[k].to >= ranks ? t->item[k].to + 1 : ranks;
    for (size_t r = 0; r < ranks; r++) {
        algebraic *time = &t->time.item[t->by_rank[r]];
        if (is_touched(t, r, r))
            TRY(add_germ_at(m, time));
        if (is_touched(t, r, r + 1))
            TRY(add_stretch(m, time, &t->time.item[t->by_rank[r + 1]]));
    }
    return GRAZE_OK;
}

static graze_status add_contacts_of_piece(germ_maker *m) {
    ZEROED(candidates, near);
    HELD(touches, t);
    TRY(candidates_find(&near, m->at.context, m->at.solid, m->at.path));
    TRY(touches_find(&t, m->at.context, m->at.solid, m->at.path, NULL, &near));
    TRY(touches_order(&t, m->at.context));
    return add_touches(m, &t);
}

/* Make a germ maker with a trajectory, which take_piece sets. The solid's complement sweeps the
 * complement of an unsweep (proofs/dangling.md C113). */
static germ_maker maker_of(germ_list *list, graze_context *context, const graze_scene *scene,
                           const plane_list *planes, trajectory *path) {
    return (germ_maker){list,
                        scene,
                        {.context = context,
                         .solid = scene->solid,
                         .outside = scene->options.operation == GRAZE_UNSWEEP,
                         .planes = planes,
                         .path = path}};
}

/* Go on with another piece. */
static void take_piece(germ_maker *m, size_t piece, const fmpq *point) {
    m->at.map = motion_tracing(&m->scene->motion->piece[piece], m->scene->options.operation);
    trajectory_set(m->at.path, m->at.map, point);
}

graze_status germs_find(germ_list *list, graze_context *context, const graze_scene *scene,
                        const plane_list *planes, const fmpq *point) {
    HELD(trajectory, path, scene->motion->dimension);
    germ_maker m = maker_of(list, context, scene, planes, &path);
    for (size_t k = 0; k < scene->motion->piece_count; k++) {
        take_piece(&m, k, point);
        TRY(add_contacts_of_piece(&m));
    }
    return GRAZE_OK;
}

graze_status germs_at(germ_list *list, graze_context *context, const graze_scene *scene,
                      const plane_list *planes, const fmpq *point, size_t piece, const fmpq_t u) {
    HELD(trajectory, path, scene->motion->dimension);
    germ_maker m = maker_of(list, context, scene, planes, &path);
    take_piece(&m, piece, point);
    return add_germ(&m, u);
}
