/* Primitives of curved solids as polynomial inequalities.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Let y be a point minus the primitive's own point, and a the primitive's axis. Then h = a . y /
 * |a| is the height of y and |y|^2 - h^2 the square of its distance from the axis. The inequalities
 * are multiplied by |a|^2, which makes their coefficients rational.
 */
#include "input/csg/csg_reader.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

/* Numbers of a primitive; 0 until they are set. */
typedef struct placed {
    fmpq *point, *axis; /* 3 each */
    fmpq *length2;      /* |axis|^2 */
    fmpq *first, *second, *from, *to;
    int has_from, has_to;
} placed;

static void placed_init(placed *p) {
    fmpq *v = _fmpq_vec_init(11);
    *p = (placed){v, v + 3, v + 6, v + 7, v + 8, v + 9, v + 10, 0, 0};
}

static void placed_clear(placed *p) {
    _fmpq_vec_clear(p->point, 11);
}

/* Read a number that must be positive. */
static graze_status read_size(fmpq_t out, csg_reader *r, const json *value) {
    TRY(csg_read_number(out, r, value));
    if (fmpq_sgn(out) <= 0)
        return json_fail(r->context, GRAZE_EILLEGAL, value, "expected a positive number");
    return GRAZE_OK;
}

static void set_from(csg_reader *r, const fmpq *point) {
    fmpq_mpoly_zero(r->square, r->ring);
    for (int i = 0; i < r->dimension; i++) {
        fmpq_mpoly_sub_fmpq(&r->from[i], &r->coordinate[i], point + i, r->ring);
        fmpq_mpoly_mul(r->term, &r->from[i], &r->from[i], r->ring);
        fmpq_mpoly_add(r->square, r->square, r->term, r->ring);
    }
}

/* Add the ball |from|^2 - radius^2 <= 0. */
static graze_status add_ball(size_t *node, csg_reader *r, const placed *p, const fmpq_t radius) {
    LOCAL(fmpq, square);
    LOCAL(fmpq, zero);
    csg_bound_round(r, p->point, NULL, radius, zero);
    fmpq_mul(square, radius, radius);
    fmpq_mpoly_sub_fmpq(r->f, r->square, square, r->ring);
    return csg_add_side(node, r, 0);
}

/* Add the half-space a . from <= bound |a|^2, or >= if `other`, for the axis a. */
static graze_status add_cap(size_t *node, csg_reader *r, const placed *p, const fmpq_t bound,
                            int other) {
    LOCAL(fmpq, level);
    fmpq_mul(level, bound, p->length2);
    fmpq_mpoly_sub_fmpq(r->f, r->along, level, r->ring);
    return csg_add_side(node, r, other);
}

/* Set f = |a|^2 |from|^2 - factor (a . from)^2 - constant for the axis a. */
static void set_about_axis(csg_reader *r, const placed *p, const fmpq_t factor,
                           const fmpq_t constant) {
    fmpq_mpoly_scalar_mul_fmpq(r->f, r->square, p->length2, r->ring);
    fmpq_mpoly_mul(r->term, r->along, r->along, r->ring);
    fmpq_mpoly_scalar_mul_fmpq(r->term, r->term, factor, r->ring);
    fmpq_mpoly_sub(r->f, r->f, r->term, r->ring);
    fmpq_mpoly_sub_fmpq(r->f, r->f, constant, r->ring);
}

/* Set f for the infinite cylinder of radius `first`. */
static void set_cylinder(csg_reader *r, const placed *p) {
    LOCAL_VEC(fmpq, one, 2);
    fmpq *constant = one + 1;
    fmpq_one(one);
    fmpq_mul(constant, p->first, p->first);
    fmpq_mul(constant, constant, p->length2);
    set_about_axis(r, p, one, constant);
}

/* Read the point and the axis; set r->from, r->square and r->along for them. */
static graze_status read_placed_axis(placed *p, csg_reader *r, const json *point,
                                     const json *axis) {
    size_t d = (size_t)r->dimension;
    LOCAL(fmpq, zero);
    TRY(csg_read_vector(p->point, r, point, d));
    TRY(csg_read_vector(p->axis, r, axis, d));
    for (size_t i = 0; i < d; i++)
        fmpq_addmul(p->length2, p->axis + i, p->axis + i);
    if (fmpq_is_zero(p->length2))
        return json_fail(r->context, GRAZE_EILLEGAL, axis,
                         "the axis is zero; expected a direction");
    set_from(r, p->point);
    csg_linear_form(r->along, r, p->axis, r->from, zero);
    return GRAZE_OK;
}

static graze_status read_bounds(placed *p, csg_reader *r, const json *from, const json *to) {
    if (from)
        TRY(csg_read_number(p->from, r, from));
    if (to)
        TRY(csg_read_number(p->to, r, to));
    p->has_from = from != NULL;
    p->has_to = to != NULL;
    if (from && to && fmpq_cmp(p->from, p->to) >= 0)
        return json_fail(r->context, GRAZE_EILLEGAL, to, "expected more than from");
    return GRAZE_OK;
}

/* Add the set f <= 0 between those of the bounds `from` and `to` that are given. */
static graze_status add_bounded(size_t *node, csg_reader *r, const placed *p) {
    size_t part[3], count = 1;
    TRY(csg_add_side(&part[0], r, 0));
    if (p->has_from)
        TRY(add_cap(&part[count++], r, p, p->from, 1));
    if (p->has_to)
        TRY(add_cap(&part[count++], r, p, p->to, 0));
    return csg_add_node(node, r, CSG_ALL, part, count);
}

/* Set the two ends of a cylinder or a cone: those given, or where the half-spaces around it end it.
 * If these leave nothing, any end will do. Returns 0 if an end is missing. */
static int round_ends(fmpq *end, csg_reader *r, const placed *p, int cone) {
    const csg_shaft body = {p->point, p->axis, p->length2, p->first, cone};
    fmpq_set(end, p->from);
    fmpq_set(end + 1, p->to);
    if ((!p->has_from && !csg_cut_height(end, r, &body, 0)) ||
        (!p->has_to && !csg_cut_height(end + 1, r, &body, 1)))
        return 0;
    if (fmpq_cmp(end, end + 1) >= 0)
        fmpq_add_si(end + !p->has_to, end + p->has_to, p->has_to ? -1 : 1);
    return 1;
}

/* Enlarge the reader's box until it holds the disks at both ends, if there are two. Their radius is
 * `first`, or, for a cone, `first` times the height. A box whose numbers half-spaces made too long
 * is dropped. */
static void bound_between(csg_reader *r, const placed *p, int cone) {
    LOCAL_VEC(fmpq, v, 7);
    fmpq *zero = v + 3, *square = v + 4, *end = v + 5;
    int ended = round_ends(end, r, p, cone), given = p->has_from && p->has_to, is_long = 0;
    for (int k = 0; k < 2 && ended; k++) {
        const fmpq *bound = end + k;
        for (int i = 0; i < 3; i++) {
            fmpq_set(v + i, p->point + i);
            fmpq_addmul(v + i, bound, p->axis + i);
        }
        fmpq_mul(square, p->first, p->first);
        for (int power = 0; power < 2 && cone; power++)
            fmpq_mul(square, square, bound);
        if (cone)
            fmpq_mul(square, square, p->length2);
        csg_bound_round(r, v, p->axis, zero, square);
    }
    for (int i = 0; i < 3 && !given; i++)
        is_long |=
            csg_is_long(r->context, &r->box.low[i]) || csg_is_long(r->context, &r->box.high[i]);
    r->box.dimension = is_long ? 0 : r->box.dimension;
}

/* Enlarge the reader's box until it holds the box about the point with `axis` as half sides. */
static void bound_about(csg_reader *r, const placed *p) {
    int d = r->dimension;
    LOCAL_VEC(fmpq, end, 2 * d);
    vector_sub(end, p->point, p->axis, d);
    vector_add(end + d, p->point, p->axis, d);
    csg_bound_corners(r, end, end + d);
}

/* Read the normal of a half-space into p->axis and its offset into p->first; set r->f. */
static graze_status read_halfspace(placed *p, csg_reader *r, const json *value) {
    static const char *const names[] = {"normal", "offset"};
    const json *member[2];
    TRY(csg_read_members(member, r, value, names, 2, 2));
    TRY(csg_read_vector(p->axis, r, member[0], (size_t)r->dimension));
    TRY(csg_read_number(p->first, r, member[1]));
    csg_linear_form(r->f, r, p->axis, r->coordinate, p->first);
    if (fmpq_mpoly_is_fmpq(r->f, r->ring))
        return json_fail(r->context, GRAZE_EILLEGAL, member[0],
                         "the normal is zero; expected a direction");
    return GRAZE_OK;
}

graze_status csg_read_halfspace(size_t *node, csg_reader *r, const json *value) {
    HELD(placed, p);
    TRY(read_halfspace(&p, r, value));
    return csg_add_side(node, r, 0);
}

graze_status csg_read_cut(csg_reader *r, const json *value) {
    HELD(placed, p);
    TRY(read_halfspace(&p, r, value));
    csg_add_cut(r, p.axis, p.first);
    return GRAZE_OK;
}

graze_status csg_read_box(size_t *node, csg_reader *r, const json *value) {
    static const char *const names[] = {"low", "high"};
    const json *member[2];
    size_t part[6], d = (size_t)r->dimension;
    LOCAL_VEC(fmpq, low, 6);
    fmpq *high = low + 3;
    TRY(csg_read_members(member, r, value, names, 2, 2));
    TRY(csg_read_vector(low, r, member[0], d));
    TRY(csg_read_vector(high, r, member[1], d));
    for (size_t i = 0; i < d; i++)
        if (fmpq_cmp(low + i, high + i) >= 0)
            return json_fail(r->context, GRAZE_EILLEGAL, member[1],
                             "expected more than low in each coordinate");
    for (size_t k = 0; k < 2 * d; k++) {
        fmpq_mpoly_sub_fmpq(r->f, &r->coordinate[k / 2], low + 3 * (k % 2) + k / 2, r->ring);
        TRY(csg_add_side(&part[k], r, k % 2 == 0));
    }
    TRY(csg_add_node(node, r, CSG_ALL, part, 2 * d));
    csg_bound_corners(r, low, high);
    return GRAZE_OK;
}

graze_status csg_read_ball(size_t *node, csg_reader *r, const json *value) {
    static const char *const names[] = {"radius", "center"};
    const json *member[2];
    HELD(placed, p);
    TRY(csg_read_members(member, r, value, names, 2, 1));
    TRY(read_size(p.first, r, member[0]));
    if (member[1])
        TRY(csg_read_vector(p.point, r, member[1], (size_t)r->dimension));
    TRY(csg_note_round(r, p.point, NULL, p.first));
    set_from(r, p.point);
    return add_ball(node, r, &p, p.first);
}

graze_status csg_read_ellipsoid(size_t *node, csg_reader *r, const json *value) {
    static const char *const names[] = {"semiaxes", "center"};
    const json *member[2];
    HELD(placed, p);
    TRY(csg_read_members(member, r, value, names, 2, 1));
    TRY(json_array(r->context, member[0], (size_t)r->dimension));
    if (member[1])
        TRY(csg_read_vector(p.point, r, member[1], (size_t)r->dimension));
    for (const json *item = member[0]->first; item; item = item->next)
        TRY(read_size(p.axis + item->index, r, item));
    set_from(r, p.point);
    fmpq_mpoly_set_si(r->f, -1, r->ring);
    for (int i = 0; i < r->dimension; i++) {
        fmpq_mpoly_scalar_div_fmpq(r->term, &r->from[i], p.axis + i, r->ring);
        fmpq_mpoly_mul(r->term, r->term, r->term, r->ring);
        fmpq_mpoly_add(r->f, r->f, r->term, r->ring);
    }
    bound_about(r, &p);
    return csg_add_side(node, r, 0);
}

/* Read the members point, axis, a size, from and to into p; the size into p->first. */
static graze_status read_between(placed *p, csg_reader *r, const json *value, const char *size) {
    const char *const names[] = {"point", "axis", size, "from", "to"};
    const json *member[5];
    TRY(csg_in_space(r, value));
    TRY(csg_read_members(member, r, value, names, 5, 3));
    TRY(read_placed_axis(p, r, member[0], member[1]));
    TRY(read_size(p->first, r, member[2]));
    return read_bounds(p, r, member[3], member[4]);
}

graze_status csg_read_cylinder(size_t *node, csg_reader *r, const json *value) {
    HELD(placed, p);
    TRY(read_between(&p, r, value, "radius"));
    bound_between(r, &p, 0);
    set_cylinder(r, &p);
    return add_bounded(node, r, &p);
}

graze_status csg_read_cone(size_t *node, csg_reader *r, const json *value) {
    HELD(placed, p);
    TRY(read_between(&p, r, value, "slope"));
    if (fmpq_sgn(p.from) < 0 || (p.has_to && fmpq_cmp(p.from, p.to) >= 0))
        return json_fail(r->context, GRAZE_EILLEGAL, value, "expected 0 <= from < to");
    p.has_from = 1;
    bound_between(r, &p, 1);
    fmpq_mul(p.second, p.first, p.first);
    fmpq_add_si(p.second, p.second, 1);
    fmpq_zero(p.first);
    set_about_axis(r, &p, p.second, p.first);
    return add_bounded(node, r, &p);
}

/* Set f = |a|^2 (|y|^2 + R^2 - r^2)^2 - 4 R^2 (|a|^2 |y|^2 - (a . y)^2), and enlarge the box. */
static void set_torus(csg_reader *r, placed *p) {
    fmpq_mul(p->from, p->first, p->first);
    csg_bound_round(r, p->point, p->axis, p->second, p->from);
    fmpq_set_si(p->to, 4, 1);
    fmpq_mul(p->to, p->to, p->from);            /* 4 R^2 */
    fmpq_submul(p->from, p->second, p->second); /* R^2 - r^2 */
    fmpq_one(p->first);
    fmpq_zero(p->second);
    set_about_axis(r, p, p->first, p->second);
    fmpq_mpoly_scalar_mul_fmpq(r->f, r->f, p->to, r->ring);
    fmpq_mpoly_add_fmpq(r->square, r->square, p->from, r->ring);
    fmpq_mpoly_mul(r->term, r->square, r->square, r->ring);
    fmpq_mpoly_scalar_mul_fmpq(r->term, r->term, p->length2, r->ring);
    fmpq_mpoly_sub(r->f, r->term, r->f, r->ring);
}

graze_status csg_read_torus(size_t *node, csg_reader *r, const json *value) {
    static const char *const names[] = {"point", "axis", "major", "minor"};
    const json *member[4];
    HELD(placed, p);
    TRY(csg_in_space(r, value));
    TRY(csg_read_members(member, r, value, names, 4, 4));
    TRY(read_placed_axis(&p, r, member[0], member[1]));
    TRY(read_size(p.first, r, member[2]));
    TRY(read_size(p.second, r, member[3]));
    if (fmpq_cmp(p.second, p.first) >= 0)
        return json_fail(r->context, GRAZE_EILLEGAL, member[3],
                         "expected less than major: a torus does not meet itself");
    set_torus(r, &p);
    return csg_add_side(node, r, 0);
}

graze_status csg_read_capsule(size_t *node, csg_reader *r, const json *value) {
    static const char *const names[] = {"point", "axis", "radius"};
    const json *member[3];
    size_t part[3];
    HELD(placed, p);
    TRY(csg_read_members(member, r, value, names, 3, 3));
    TRY(read_placed_axis(&p, r, member[0], member[1]));
    TRY(read_size(p.first, r, member[2]));
    TRY(csg_note_round(r, p.point, p.axis, p.first));
    set_cylinder(r, &p);
    fmpq_one(p.to);
    p.has_from = p.has_to = 1;
    TRY(add_bounded(&part[0], r, &p));
    TRY(add_ball(&part[1], r, &p, p.first));
    vector_add(p.point, p.point, p.axis, r->dimension);
    set_from(r, p.point);
    TRY(add_ball(&part[2], r, &p, p.first));
    return csg_add_node(node, r, CSG_ANY, part, 3);
}
