/* Polynomials and polygons of curved solids.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A point is in a polygon iff the ray downwards from it crosses an odd number of edges, that is,
 * iff it is in an odd number of strips: the strip of an edge is the set of points above the edge,
 * between the vertical lines through its ends. Where such a line is no boundary of the polygon, its
 * sign does not change the parity. For a revolved polygon the ray goes from the point away from the
 * axis, and the strip of an edge is the part of a cone or a cylinder inside the edge, between the
 * planes through its ends. A polygon that is scaled as it is extruded has coordinates, and so
 * strips, that are linear in the height.
 */
#include "input/csg/csg_reader.h"

#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/vector.h"

/* Read powers from a key such as "2,0,1". */
static graze_status read_powers(ulong *out, csg_reader *r, const json *term) {
    int d = r->dimension, degree = 0, good = term->key_length == (size_t)(2 * d - 1);
    for (int i = 0; i < d && good; i++) {
        char digit = term->key[2 * i];
        good = digit >= '0' && digit <= '0' + CSG_DEGREE &&
               (i == d - 1 || term->key[2 * i + 1] == ',');
        out[i] = (ulong)(digit - '0');
        degree += digit - '0';
    }
    if (good && degree <= CSG_DEGREE)
        return GRAZE_OK;
    return json_fail(r->context, GRAZE_EINPUT, term,
                     "expected powers of the %d coordinates with commas, such as \"%s\", of degree "
                     "at most %d",
                     d, d == 2 ? "2,0" : "2,0,1", CSG_DEGREE);
}

/* Add a coefficient times the powers of the coordinates to f. */
static void add_term(csg_reader *r, const fmpq_t coefficient, const ulong *power) {
    fmpq_mpoly_set_fmpq(r->term, coefficient, r->ring);
    for (int i = 0; i < r->dimension; i++)
        for (ulong k = 0; k < power[i]; k++)
            fmpq_mpoly_mul(r->term, r->term, &r->coordinate[i], r->ring);
    fmpq_mpoly_add(r->f, r->f, r->term, r->ring);
}

graze_status csg_read_polynomial(size_t *node, csg_reader *r, const json *value) {
    graze_context *context = r->context;
    LOCAL(fmpq, coefficient);
    ulong power[3];
    if (value->kind != JSON_OBJECT)
        return json_fail(context, GRAZE_EINPUT, value,
                         "expected an object of coefficients by powers");
    fmpq_mpoly_zero(r->f, r->ring);
    for (const json *term = value->first; term; term = term->next) {
        TRY(read_powers(power, r, term));
        for (const json *other = value->first; other != term; other = other->next)
            if (!strcmp(other->key, term->key))
                return json_fail(context, GRAZE_EINPUT, term,
                                 "this key is repeated; the first is in line %zu", other->line);
        TRY(csg_read_number(coefficient, r, term));
        add_term(r, coefficient, power);
    }
    if (fmpq_mpoly_is_zero(r->f, r->ring))
        return json_fail(context, GRAZE_EILLEGAL, value,
                         "the polynomial is zero; expected a coefficient that is not");
    return csg_add_side(node, r, 0);
}

/* The nodes of a polygon's edges and a box of the polygon, whose last coordinate has the heights of
 * a prism. */
typedef struct polygon_edges {
    size_t *node, count, capacity;
    int revolved; /* about the z axis: a point is its distance from the axis and its height */
    int slanted;  /* 1: an edge is along no axis */
    csg_box box;
    fmpq *scale, *growth; /* 2 each: at height z coordinate i is times scale[i] + growth[i] z */
} polygon_edges;

static void polygon_edges_init(polygon_edges *e) {
    *e = (polygon_edges){.scale = _fmpq_vec_init(4)};
    e->growth = e->scale + 2;
    for (int i = 0; i < 2; i++)
        fmpq_one(e->scale + i);
    csg_box_init(&e->box);
}

static void polygon_edges_clear(polygon_edges *e) {
    free(e->node);
    _fmpq_vec_clear(e->scale, 4);
    csg_box_clear(&e->box);
}

/* Set r->f to n[0] x + n[1] y - c, where the number c is scaled with coordinate i. */
static void set_scaled_form(const polygon_edges *e, csg_reader *r, fmpq *n, const fmpq *c, int i) {
    LOCAL(fmpq, constant);
    fmpq_mul(constant, c, e->scale + i);
    if (!e->revolved) {
        fmpq_mul(n + 2, c, e->growth + i);
        fmpq_neg(n + 2, n + 2);
    }
    csg_linear_form(r->f, r, n, r->coordinate, constant);
}

/* Add the strip of the edge from p to q: the set r->f <= 0 between the lines, or planes, through p
 * and q, whose coordinates `along` differ. */
static graze_status add_strip(polygon_edges *e, csg_reader *r, const fmpq *p, const fmpq *q,
                              int along) {
    const fmpq *end[2] = {p + along, q + along};
    size_t part[3];
    LOCAL_VEC(fmpq, n, 3);
    fmpq_one(n + (e->revolved ? 2 : 0));
    TRY(array_grow(r->context, &e->node, &e->capacity, e->count + 1, sizeof *e->node,
                   "the edges of a polygon"));
    TRY(csg_add_side(&part[0], r, 0));
    for (int k = 0; k < 2; k++) {
        set_scaled_form(e, r, n, end[fmpq_cmp(end[0], end[1]) < 0 ? k : 1 - k], 0);
        TRY(csg_add_side(&part[1 + k], r, k == 0));
    }
    return csg_add_node(&e->node[e->count++], r, CSG_ALL, part, 3);
}

/* Add the points above the edge from p to q, none if the edge is vertical. */
static graze_status add_edge(polygon_edges *e, csg_reader *r, const fmpq *p, const fmpq *q) {
    const fmpq *left = fmpq_cmp(p, q) < 0 ? p : q, *right = left == p ? q : p;
    if (fmpq_equal(p, q))
        return GRAZE_OK;
    LOCAL_VEC(fmpq, n, 4);
    fmpq_sub(n, right + 1, left + 1);
    fmpq_sub(n + 1, left, right);
    fmpq_mul(n + 3, n, left);
    fmpq_addmul(n + 3, n + 1, left + 1);
    e->slanted |= !fmpq_is_zero(n);
    set_scaled_form(e, r, n, n + 3, fmpq_is_zero(n));
    return add_strip(e, r, p, q, 0);
}

/* Move the end p of an edge, if it is beyond the axis, to the point in which the edge meets the
 * axis.
 */
static void cut_at_axis(fmpq *p, const fmpq *q) {
    LOCAL_VEC(fmpq, v, 2);
    if (fmpq_sgn(p) < 0) {
        fmpq_sub(v, q, p);
        fmpq_sub(v + 1, q + 1, p + 1);
        fmpq_div(v, v + 1, v);
        fmpq_submul(p + 1, p, v);
        fmpq_zero(p);
    }
}

/* Add the points that the edge from p to q encloses as it turns, between the heights of p and q:
 * (height of the edge)^2 |(x, y)|^2 <= l^2, where the form l of z is that height times the edge's
 * distance from the axis. */
static graze_status add_revolved_edge(polygon_edges *e, csg_reader *r, const fmpq *p,
                                      const fmpq *q) {
    if (fmpq_equal(p + 1, q + 1) || (fmpq_sgn(p) <= 0 && fmpq_sgn(q) <= 0))
        return GRAZE_OK;
    LOCAL_VEC(fmpq, v, 9);
    fmpq *from = v, *to = v + 2, *height = v + 4, *constant = v + 5;
    vector_set(from, p, 2);
    vector_set(to, q, 2);
    cut_at_axis(from, q);
    cut_at_axis(to, p);
    fmpq_sub(height, to + 1, from + 1);
    fmpq_sub(v + 8, to, from);
    fmpq_mul(constant, v + 8, from + 1);
    fmpq_submul(constant, from, height);
    csg_linear_form(r->along, r, v + 6, r->coordinate, constant);
    fmpq_mul(height, height, height);
    fmpq_mpoly_mul(r->f, &r->coordinate[0], &r->coordinate[0], r->ring);
    fmpq_mpoly_mul(r->term, &r->coordinate[1], &r->coordinate[1], r->ring);
    fmpq_mpoly_add(r->f, r->f, r->term, r->ring);
    fmpq_mpoly_scalar_mul_fmpq(r->f, r->f, height, r->ring);
    fmpq_mpoly_mul(r->term, r->along, r->along, r->ring);
    fmpq_mpoly_sub(r->f, r->f, r->term, r->ring);
    return add_strip(e, r, from, to, 1);
}

static graze_status read_polygon_ring(polygon_edges *e, csg_reader *r, const json *value) {
    graze_status (*add)(polygon_edges *, csg_reader *, const fmpq *, const fmpq *) =
        e->revolved ? add_revolved_edge : add_edge;
    TRY(json_array(r->context, value, 0));
    if (value->count < 3)
        return json_fail(r->context, GRAZE_EINPUT, value, "expected at least 3 points, not %zu",
                         value->count);
    LOCAL_VEC(fmpq, point, 6);
    fmpq *first = point, *last = point + 2, *next = point + 4;
    for (const json *item = value->first; item; item = item->next) {
        TRY(csg_read_vector(next, r, item, 2));
        for (int i = 0; i < 2; i++)
            csg_box_hold(&e->box, i, next + i, next + i);
        e->box.dimension = 2;
        if (item->index > 0)
            TRY(add(e, r, last, next));
        vector_set(item->index > 0 ? last : first, next, 2);
        vector_set(last, next, 2);
    }
    return add(e, r, last, first);
}

/* Read the heights of a prism, and the factors of a polygon's coordinates at the second one. */
static graze_status read_heights(polygon_edges *e, csg_reader *r, const json *heights,
                                 const json *scale) {
    LOCAL_VEC(fmpq, v, 4);
    fmpq *low = v, *high = v + 1, *factor = v + 2;
    TRY(csg_read_vector(low, r, heights, 2));
    if (fmpq_cmp(low, high) >= 0)
        return json_fail(r->context, GRAZE_EILLEGAL, heights,
                         "expected a second height above the first");
    fmpq_set(&e->box.low[2], low);
    fmpq_set(&e->box.high[2], high);
    if (!scale)
        return GRAZE_OK;
    TRY(csg_read_vector(factor, r, scale, 2));
    if (fmpq_sgn(factor) < 0 || fmpq_sgn(factor + 1) < 0)
        return json_fail(r->context, GRAZE_EILLEGAL, scale,
                         "expected factors that are not negative");
    fmpq_sub(high, high, low);
    for (int i = 0; i < 2; i++) {
        fmpq_sub_si(e->growth + i, factor + i, 1);
        fmpq_div(e->growth + i, e->growth + i, high);
        fmpq_submul(e->scale + i, e->growth + i, low);
    }
    return GRAZE_OK;
}

/* Replace the node of a polygon by its prism, and scale its box. */
static graze_status extrude(size_t *node, polygon_edges *e, csg_reader *r, const json *scale) {
    size_t part[3] = {*node, 0, 0};
    LOCAL_VEC(fmpq, v, 2);
    if (e->slanted && !fmpq_equal(e->growth, e->growth + 1))
        return json_fail(r->context, GRAZE_EILLEGAL, scale,
                         "expected equal factors, as an edge is along no axis");
    for (int k = 0; k < 2; k++) {
        const fmpq *height = k ? &e->box.high[2] : &e->box.low[2];
        fmpq_mpoly_sub_fmpq(r->f, &r->coordinate[2], height, r->ring);
        TRY(csg_add_side(&part[1 + k], r, k == 0));
    }
    for (int i = 0; i < 2; i++) {
        fmpq_set(v + 1, e->scale + i);
        fmpq_addmul(v + 1, e->growth + i, &e->box.high[2]);
        fmpq_mul(v, v + 1, &e->box.low[i]);
        fmpq_mul(v + 1, v + 1, &e->box.high[i]);
        csg_box_hold(&e->box, i, v, v + 1);
    }
    return csg_add_node(node, r, CSG_ALL, part, 3);
}

/* Set *revolved, and check that a polygon in space is either extruded or revolved, one in the plane
 * neither. */
static graze_status polygon_form(int *revolved, csg_reader *r, const json *value,
                                 const json *extruded, const json *turns, const json *scale) {
    graze_context *context = r->context;
    *revolved = turns != NULL;
    if (scale && !extruded)
        return json_fail(context, GRAZE_EINPUT, scale, "expected the key extrude beside it");
    if ((extruded != NULL) + (turns != NULL) != (r->dimension == 3))
        return json_fail(context, GRAZE_EINPUT, value,
                         r->dimension == 3 ? "expected one of the keys extrude and revolve, which "
                                             "a polygon in space needs"
                                           : "expected no extrude and no revolve in the plane");
    if (!turns)
        return GRAZE_OK;
    LOCAL(fmpz, whole);
    TRY(entry_integer(whole, context, turns));
    if (!fmpz_is_one(whole))
        return json_fail(context, GRAZE_EINPUT, turns, "expected 1, a whole turn");
    return GRAZE_OK;
}

/* Turn the box of a polygon into a box of the revolved polygon. */
static void revolve_box(csg_box *box) {
    fmpq_swap(&box->low[1], &box->low[2]);
    fmpq_swap(&box->high[1], &box->high[2]);
    fmpq_set(&box->high[1], &box->high[0]);
    fmpq_neg(&box->low[0], &box->high[0]);
    fmpq_set(&box->low[1], &box->low[0]);
}

graze_status csg_read_polygon(size_t *node, csg_reader *r, const json *value) {
    static const char *const names[] = {"points", "holes", "extrude", "revolve", "scale"};
    graze_context *context = r->context;
    const json *member[5];
    HELD(polygon_edges, e);
    TRY(csg_read_members(member, r, value, names, 5, 1));
    TRY(polygon_form(&e.revolved, r, value, member[2], member[3], member[4]));
    if (member[2])
        TRY(read_heights(&e, r, member[2], member[4]));
    TRY(read_polygon_ring(&e, r, member[0]));
    if (member[1])
        TRY(json_array(context, member[1], 0));
    for (const json *hole = member[1] ? member[1]->first : NULL; hole; hole = hole->next)
        TRY(read_polygon_ring(&e, r, hole));
    if (e.count == 0)
        return json_fail(context, GRAZE_EILLEGAL, value, "the polygon has no interior");
    TRY(csg_add_node(node, r, CSG_ODD, e.node, e.count));
    if (member[2])
        TRY(extrude(node, &e, r, member[4]));
    if (e.revolved)
        revolve_box(&e.box);
    csg_bound_corners(r, e.box.low, e.box.high);
    return GRAZE_OK;
}
