/* Facets cut into triangles in the way proofs/certificate.md lays down: the first ear each time;
 * facets that are not planar as a fan.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "certify/cut.h"

#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include <string.h>
#include "number/cross.h"
#include "solid/create.h"

enum { MOST_CORNERS = 500 }; /* as in the checker */

/* The corners left of a facet, seen along an axis in which its normal is not zero. */
typedef struct outline {
    const soup *s;
    size_t count, *corner;
    int b, c, sign;
} outline;

static const fmpq *position_of(const soup *s, size_t vertex) {
    return s->coordinates + 3 * vertex;
}

/* The sum of the areas of a fan, for each axis: the normal. */
static void find_normal(fmpq *normal, const outline *o) {
    fmpq_t part;
    fmpq_init(part);
    for (int axis = 0; axis < 3; axis++) {
        fmpq_zero(normal + axis);
        for (size_t k = 1; k + 1 < o->count; k++) {
            cross_rationals(part, position_of(o->s, o->corner[0]), position_of(o->s, o->corner[k]),
                            position_of(o->s, o->corner[k + 1]), (axis + 1) % 3, (axis + 2) % 3);
            fmpq_add(normal + axis, normal + axis, part);
        }
    }
    fmpq_clear(part);
}

/* Set the axis; 1 if the corners lie in one plane. */
static int look_along(outline *o) {
    fmpq *normal = _fmpq_vec_init(3);
    fmpq_t sum, first, term;
    fmpq_init(sum);
    fmpq_init(first);
    fmpq_init(term);
    find_normal(normal, o);
    int axis = 0, planar = 1;
    while (axis < 2 && fmpq_is_zero(normal + axis))
        axis++;
    o->b = (axis + 1) % 3;
    o->c = (axis + 2) % 3;
    o->sign = fmpq_sgn(normal + axis);
    for (size_t k = 0; k < o->count && planar; k++) {
        fmpq_zero(sum);
        for (int i = 0; i < 3; i++) {
            fmpq_mul(term, normal + i, position_of(o->s, o->corner[k]) + i);
            fmpq_add(sum, sum, term);
        }
        planar = k == 0 || fmpq_equal(sum, first);
        fmpq_set(first, sum);
    }
    fmpq_clear(sum);
    fmpq_clear(first);
    fmpq_clear(term);
    _fmpq_vec_clear(normal, 3);
    return planar;
}

static int turn_of(const outline *o, size_t p, size_t q, size_t r) {
    fmpq_t a;
    fmpq_init(a);
    cross_rationals(a, position_of(o->s, p), position_of(o->s, q), position_of(o->s, r), o->b,
                    o->c);
    int sign = o->sign * fmpq_sgn(a);
    fmpq_clear(a);
    return sign;
}

static int is_ear(const outline *o, size_t k) {
    size_t n = o->count;
    size_t p = o->corner[(k + n - 1) % n], q = o->corner[k], r = o->corner[(k + 1) % n];
    if (turn_of(o, p, q, r) <= 0)
        return 0;
    for (size_t i = 2; i + 1 < n; i++) {
        size_t x = o->corner[(k + i) % n];
        if (turn_of(o, p, q, x) >= 0 && turn_of(o, q, r, x) >= 0 && turn_of(o, r, p, x) >= 0)
            return 0;
    }
    return 1;
}

static graze_status add_triangle(soup *out, graze_context *context, size_t p, size_t q, size_t r) {
    size_t corner[3] = {p, q, r};
    graze_status status = soup_add_facet(out, context);
    return status ? status : soup_add_cycle(out, context, corner, 3);
}

static graze_status cut_ears(soup *out, graze_context *context, outline *o, size_t facet) {
    graze_status status = GRAZE_OK;
    while (o->count >= 3 && !status) {
        size_t k = 0, n = o->count;
        while (k < n && !is_ear(o, k))
            k++;
        if (k == n)
            return context_fail(context, GRAZE_EILLEGAL,
                                "facet %zu touches itself, and a checker cannot cut it into "
                                "triangles; right are triangles in its place",
                                facet);
        status = add_triangle(out, context, o->corner[(k + n - 1) % n], o->corner[k],
                              o->corner[(k + 1) % n]);
        if (n == 3)
            break;
        memmove(o->corner + k, o->corner + k + 1, (n - k - 1) * sizeof *o->corner);
        o->count--;
    }
    return status;
}

static int same_position(const soup *s, size_t v, size_t w) {
    const fmpq *a = position_of(s, v), *b = position_of(s, w);
    return fmpq_equal(a, b) && fmpq_equal(a + 1, b + 1) && fmpq_equal(a + 2, b + 2);
}

/* The corners of a cycle that are not at the position of the one before. */
static void take_corners(outline *o, const uint32_t *index, size_t n) {
    o->count = 0;
    for (size_t k = 0; k < n; k++)
        if (n == 3 || !same_position(o->s, index[k], index[(k + n - 1) % n]))
            o->corner[o->count++] = index[k];
}

static graze_status certify_facet(soup *out, graze_context *context, const soup *in, size_t facet,
                                  unsigned flags) {
    size_t cycle = in->facet_start[facet], first = in->cycle_start[cycle];
    size_t n = in->cycle_start[cycle + 1] - first;
    if (in->facet_start[facet + 1] - cycle != 1)
        return context_fail(context, GRAZE_EILLEGAL,
                            "facet %zu has holes; right is a solid in .off, whose facets have none",
                            facet);
    if (n > MOST_CORNERS)
        return context_fail(context, GRAZE_EILLEGAL,
                            "facet %zu has %zu corners, too many for a checker to cut; right are "
                            "at most %d",
                            facet, n, MOST_CORNERS);
    outline o = {in, n, malloc(n * sizeof *o.corner), 0, 0, 0};
    if (!o.corner)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a facet");
    take_corners(&o, in->index + first, n);
    n = o.count;
    graze_status status = GRAZE_OK;
    if (n > 3 && (look_along(&o) || !(flags & GRAZE_SOLID_TRIANGULATE)))
        status = cut_ears(out, context, &o, facet);
    else
        for (size_t k = 1; k + 1 < n && !status; k++)
            status = add_triangle(out, context, o.corner[0], o.corner[k], o.corner[k + 1]);
    free(o.corner);
    return status;
}

graze_status certify_cut(graze_solid **out, graze_context *context, const graze_solid *solid,
                         unsigned flags) {
    const soup *in = &solid->input;
    *out = NULL;
    if (in->dimension == 2 || in->index_count == 3 * in->facet_count)
        return GRAZE_OK;
    soup cut;
    soup_init(&cut, 3);
    graze_status status = GRAZE_OK;
    for (size_t v = 0; v < in->vertex_count && !status; v++)
        status = soup_add_vertex(&cut, context, position_of(in, v));
    for (size_t f = 0; f < in->facet_count && !status; f++)
        status = certify_facet(&cut, context, in, f, flags);
    if (!status)
        return solid_create(out, context, &cut, 0);
    soup_clear(&cut);
    return status;
}
