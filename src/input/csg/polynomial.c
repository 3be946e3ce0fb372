/* Polynomials and polygons of curved solids.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A point is in a polygon iff the vertical ray below it crosses an odd number of edges: over each
 * edge stands the set of points above it, between the vertical lines through its ends. Where these
 * lines bound nothing, flipping their sign does not change the parity.
 */
#include "input/csg/polynomial.h"

#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"
#include "input/csg/csg_bound.h"
#include "input/motion/entry.h"

/* Powers from a key such as "2,0,1". */
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
    return json_fail(r->build.context, GRAZE_EINPUT, term,
                     "expected powers of the %d coordinates with commas, such as \"%s\", of degree "
                     "at most %d",
                     d, d == 2 ? "2,0" : "2,0,1", CSG_DEGREE);
}

/* Add a coefficient times the powers of the coordinates to f. */
static void add_term(csg_reader *r, const fmpq_t coefficient, const ulong *power) {
    const fmpq_mpoly_ctx_struct *ring = r->build.ring;
    fmpq_mpoly_set_fmpq(&r->term, coefficient, ring);
    for (int i = 0; i < r->dimension; i++)
        for (ulong k = 0; k < power[i]; k++)
            fmpq_mpoly_mul(&r->term, &r->term, &r->coordinate[i], ring);
    fmpq_mpoly_add(&r->f, &r->f, &r->term, ring);
}

graze_status csg_read_polynomial(size_t *node, csg_reader *r, const json *value) {
    graze_context *context = r->build.context;
    fmpq_t coefficient;
    ulong power[3];
    graze_status status = GRAZE_OK;
    if (value->kind != JSON_OBJECT)
        return json_fail(context, GRAZE_EINPUT, value,
                         "expected an object of coefficients by powers");
    fmpq_init(coefficient);
    fmpq_mpoly_zero(&r->f, r->build.ring);
    for (const json *term = value->first; term && !status; term = term->next) {
        status = read_powers(power, r, term);
        for (const json *other = value->first; other != term && !status; other = other->next)
            if (!strcmp(other->key, term->key))
                status = json_fail(context, GRAZE_EINPUT, term,
                                   "this key is repeated; the first is in line %zu", other->line);
        if (!status)
            status = entry_number(coefficient, context, term);
        if (!status)
            add_term(r, coefficient, power);
    }
    fmpq_clear(coefficient);
    if (!status && fmpq_mpoly_is_zero(&r->f, r->build.ring))
        status = json_fail(context, GRAZE_EILLEGAL, value,
                           "the polynomial is zero; expected a coefficient that is not");
    return status ? status : csg_add_side(node, r, 0);
}

/* The nodes of the edges of a polygon, and its box. */
typedef struct edges {
    size_t *node, count, capacity;
    int bounded;      /* the box holds a point */
    fmpq *low, *high; /* 3 each; heights of a prism last */
} edges;

/* Let the box hold a point. */
static void hold_corner(edges *e, const fmpq *point) {
    for (int i = 0; i < 2; i++) {
        if (!e->bounded || fmpq_cmp(point + i, e->low + i) < 0)
            fmpq_set(e->low + i, point + i);
        if (!e->bounded || fmpq_cmp(point + i, e->high + i) > 0)
            fmpq_set(e->high + i, point + i);
    }
    e->bounded = 1;
}

/* The points above the edge from p to q, between the vertical lines through p and q. */
static graze_status add_edge(edges *e, csg_reader *r, const fmpq *p, const fmpq *q) {
    const fmpq *left = fmpq_cmp(p, q) < 0 ? p : q, *right = left == p ? q : p;
    size_t part[3];
    if (fmpq_equal(p, q))
        return GRAZE_OK;
    graze_status status = array_grow(r->build.context, &e->node, &e->capacity, e->count + 1,
                                     sizeof *e->node, "the edges of a polygon");
    fmpq *n = _fmpq_vec_init(4);
    fmpq_sub(n, right + 1, left + 1);
    fmpq_sub(n + 1, left, right);
    fmpq_mul(n + 3, n, left);
    fmpq_addmul(n + 3, n + 1, left + 1);
    csg_linear_form(&r->f, r, n, r->coordinate, n + 3);
    if (!status)
        status = csg_add_side(&part[0], r, 0);
    fmpq_mpoly_sub_fmpq(&r->f, &r->coordinate[0], left, r->build.ring);
    if (!status)
        status = csg_add_side(&part[1], r, 1);
    fmpq_mpoly_sub_fmpq(&r->f, &r->coordinate[0], right, r->build.ring);
    if (!status)
        status = csg_add_side(&part[2], r, 0);
    if (!status)
        status = csg_add_node(&e->node[e->count++], &r->build, CSG_ALL, part, 3);
    _fmpq_vec_clear(n, 4);
    return status;
}

static graze_status read_polygon_ring(edges *e, csg_reader *r, const json *value) {
    graze_status status = json_array(r->build.context, value, 0);
    if (!status && value->count < 3)
        status = json_fail(r->build.context, GRAZE_EINPUT, value,
                           "expected at least 3 points, not %zu", value->count);
    if (status)
        return status;
    fmpq *point = _fmpq_vec_init(6), *first = point, *last = point + 2, *next = point + 4;
    for (const json *item = value->first; item && !status; item = item->next) {
        status = csg_read_vector(next, r, item, 2);
        hold_corner(e, next);
        if (!status && item->index > 0)
            status = add_edge(e, r, last, next);
        for (int i = 0; i < 2; i++) {
            fmpq_set(item->index > 0 ? last + i : first + i, next + i);
            fmpq_set(last + i, next + i);
        }
    }
    if (!status)
        status = add_edge(e, r, last, first);
    _fmpq_vec_clear(point, 6);
    return status;
}

/* The prism between two heights. */
static graze_status extrude(size_t *node, edges *e, csg_reader *r, const json *value) {
    size_t part[3] = {*node, 0, 0};
    fmpq *height = _fmpq_vec_init(2);
    graze_status status = csg_read_vector(height, r, value, 2);
    if (!status && fmpq_cmp(height, height + 1) >= 0)
        status = json_fail(r->build.context, GRAZE_EILLEGAL, value,
                           "expected a second height above the first");
    for (int k = 0; k < 2 && !status; k++) {
        fmpq_mpoly_sub_fmpq(&r->f, &r->coordinate[2], height + k, r->build.ring);
        status = csg_add_side(&part[1 + k], r, k == 0);
    }
    fmpq_swap(e->low + 2, height);
    fmpq_swap(e->high + 2, height + 1);
    _fmpq_vec_clear(height, 2);
    return status ? status : csg_add_node(node, &r->build, CSG_ALL, part, 3);
}

graze_status csg_read_polygon(size_t *node, csg_reader *r, const json *value) {
    static const char *const names[] = {"points", "holes", "extrude"};
    graze_context *context = r->build.context;
    const json *member[3];
    edges e = {.low = _fmpq_vec_init(6)};
    e.high = e.low + 3;
    graze_status status = json_members(member, context, value, names, 3);
    if (!status && !member[0])
        status = json_fail(context, GRAZE_EINPUT, value, "the key points is missing");
    if (!status && (member[2] != NULL) != (r->dimension == 3))
        status = json_fail(context, GRAZE_EINPUT, value,
                           r->dimension == 3 ? "the key extrude is missing, which a polygon in "
                                               "space needs"
                                             : "expected no extrude in the plane");
    if (!status)
        status = read_polygon_ring(&e, r, member[0]);
    if (!status && member[1])
        status = json_array(context, member[1], 0);
    const json *hole = !status && member[1] ? member[1]->first : NULL;
    for (; hole && !status; hole = hole->next)
        status = read_polygon_ring(&e, r, hole);
    if (!status && e.count == 0)
        status = json_fail(context, GRAZE_EILLEGAL, value, "the polygon has no interior");
    if (!status)
        status = csg_add_node(node, &r->build, CSG_ODD, e.node, e.count);
    if (!status && member[2])
        status = extrude(node, &e, r, member[2]);
    if (!status)
        csg_bound_corners(r, e.low, e.high);
    free(e.node);
    _fmpq_vec_clear(e.low, 6);
    return status;
}
