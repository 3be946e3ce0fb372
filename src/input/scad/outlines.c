/* Writes primitives of the plane: as they are, as prisms, or revolved about an axis.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "input/csg/csg.h"
#include "input/motion/motion.h"
#include "input/scad/hull.h"

/* The image of (x, y) under the writer's map. */
static void map_point(fmpq *out, const scad_writer *w, const fmpq *x) {
    for (int i = 0; i < 2; i++) {
        fmpq_mul(out + i, w->map + 3 * i, x);
        fmpq_addmul(out + i, w->map + 3 * i + 1, x + 1);
        fmpq_add(out + i, out + i, w->map + 3 * i + 2);
    }
}

static graze_status take_corner(scad_shape *r, scad_writer *w, const fmpq *x) {
    LOCAL_VEC(fmpq, image, 3);
    map_point(image, w, x);
    scad_hold(w->reach, x, 2);
    return hull_add_point(&r->points, w->context, image, "the points of a polygon");
}

static graze_status end_ring(scad_shape *r, scad_writer *w) {
    return numbers_add(&r->end, w->context, r->points.count, "the rings of a polygon");
}

/* Read a ring of points, to which the writer's map is applied, by their numbers. */
static graze_status read_path(scad_shape *r, scad_writer *w, const scad_place *p, field path,
                              const fmpq *point, size_t count) {
    field rest, item;
    TRY(scad_list(&rest, p, path));
    while (scad_item(&item, &rest)) {
        size_t k;
        TRY(scad_index(&k, p, item, count));
        TRY(take_corner(r, w, point + 2 * k));
    }
    return end_ring(r, w);
}

static graze_status read_point_rings(scad_shape *r, scad_writer *w, const scad_place *p) {
    field list, value, rest, item;
    size_t count = 0;
    TRY(scad_known(p, "points paths convexity"));
    TRY(scad_named_list(&list, p, "points"));
    for (rest = list; scad_item(&item, &rest);)
        count++;
    LOCAL_VEC(fmpq, point, (slong)(2 * count));
    for (size_t k = 0; scad_item(&item, &list); k += 2)
        TRY(scad_vector(point + k, p, item, 2));
    if (scad_value(&value, p, "paths")) {
        TRY(scad_list(&rest, p, value));
        while (scad_item(&item, &rest))
            TRY(read_path(r, w, p, item, point, count));
    } else {
        for (size_t k = 0; k < count; k++)
            TRY(take_corner(r, w, point + 2 * k));
        TRY(end_ring(r, w));
    }
    if (r->end.count == 0)
        return scad_fail(p, GRAZE_EILLEGAL, "expected a path");
    return GRAZE_OK;
}

static graze_status read_square(scad_shape *r, scad_writer *w, const scad_place *p) {
    LOCAL_VEC(fmpq, low, 6);
    fmpq *high = low + 2, *corner = low + 4;
    TRY(scad_box(low, high, w, p, 2));
    for (int k = 0; k < 4; k++) {
        fmpq_set(corner, k == 1 || k == 2 ? high : low);
        fmpq_set(corner + 1, (k < 2 ? low : high) + 1);
        TRY(take_corner(r, w, corner));
    }
    return end_ring(r, w);
}

/* The hull, the sum, or the offset of the parts of a node. */
static graze_status read_hull(scad_shape *r, scad_writer *w, const scad_place *p) {
    LOCAL_VEC(fmpq, x, 2);
    TRY(scad_hull(r, w, p));
    for (size_t k = 0; k < r->points.count; k++) {
        vector_set(x, r->points.at + 3 * k, 2);
        map_point(r->points.at + 3 * k, w, x);
        scad_hold(w->reach, x, 2);
    }
    fmpq_abs(x, r->radius);
    fmpq_add(w->reach, w->reach, x);
    return GRAZE_OK;
}

static graze_status read_sided_circle(scad_shape *r, scad_writer *w, const scad_place *p) {
    LOCAL_VEC(fmpq, v, 3);
    size_t sides;
    TRY(scad_known(p, "r"));
    TRY(scad_sides(&sides, w, p));
    TRY(scad_size(v + 2, p, "r"));
    for (size_t k = 0; k < sides; k++) {
        scad_corner(v, k, sides, v + 2);
        TRY(take_corner(r, w, v));
    }
    return end_ring(r, w);
}

static graze_status read_rings(scad_shape *r, scad_writer *w, const scad_place *p) {
    scad_role role = p->file->node[p->node].role;
    return role == SCAD_SQUARE   ? read_square(r, w, p)
           : role == SCAD_CIRCLE ? read_sided_circle(r, w, p)
           : role < SCAD_CUBE    ? read_hull(r, w, p)
                                 : read_point_rings(r, w, p);
}

/* A square as a box. */
static graze_status write_square(scad_writer *w, const scad_place *p) {
    int d = w->form == SCAD_PRISM ? 3 : 2;
    LOCAL_VEC(fmpq, low, 6);
    fmpq *high = low + 3;
    TRY(scad_box(low, high, w, p, 2));
    fmpq_set(low + 2, w->height);
    fmpq_set(high + 2, w->height + 1);
    scad_put_box(w, p, low, high, d);
    return GRAZE_OK;
}

static graze_status write_polygon(scad_writer *w, const scad_place *p) {
    HELD(scad_shape, r);
    LOCAL(fmpq, radius);
    TRY(read_rings(&r, w, p));
    if (r.notched.vertex_count > 0 && w->form == SCAD_REVOLVED)
        return scad_fail(p, GRAZE_EINPUT, "of a part with a notch, and revolved; expected no turn");
    if (r.notched.vertex_count > 0)
        return scad_put_sum(w, p, &r);
    if (fmpq_is_zero(r.radius)) {
        scad_put_polygon(w, p, &r);
        return GRAZE_OK;
    }
    if (w->form == SCAD_REVOLVED || (scad_is_tapered(w) && !r.mitred))
        return scad_fail(
            p, GRAZE_EINPUT,
            "round or moved edges, and revolved or scaled; expected flat parts, or a prism");
    fmpq_abs(radius, r.radius);
    scad_open(w, p, fmpq_sgn(r.radius) < 0 ? "difference" : "union", '[');
    if (r.points.count > 2)
        scad_put_polygon(w, p, &r);
    for (size_t ring = 0, first = 0; ring < r.end.count; first = r.end.item[ring++])
        for (size_t k = first, count = r.end.item[ring] - first; k < r.end.item[ring]; k++) {
            const fmpq *corner[4];
            for (size_t i = 0; i < 4; i++)
                corner[i] = r.points.at + 3 * (first + (k - first + count - 1 + i) % count);
            HELD(scad_shape, piece);
            if (r.mitred) {
                TRY(scad_moved_edge(&piece, w, p, r.radius, corner));
                scad_put_polygon(w, p, &piece);
            } else if (r.points.count != 2 || k == 0 || w->form == SCAD_PRISM) {
                TRY(scad_put_segment(w, p, corner[1], corner[2], radius));
            }
        }
    json_ends(&w->json, "]}");
    return GRAZE_OK;
}

/* Multiply a circle's radius by the scale of the writer's map, which must keep it a circle. */
static graze_status map_radius(fmpq_t out, const scad_writer *w, const scad_place *p) {
    LOCAL(fmpq, scale);
    int round = csg_scale(scale, w->map, 2, 3);
    fmpq_mul(out, out, scale);
    return round ? GRAZE_OK
                 : scad_fail(p, GRAZE_EINPUT,
                             "maps make it an ellipse; expected a circle that is revolved");
}

/* Write the torus of a circle that touches the axis: (x^2 + y^2 + z^2)^2 <= 4 r^2 (x^2 + y^2),
 * moved to its centre. Half of a box about it holds it. */
static void put_horn_torus(scad_writer *w, const scad_place *p, const fmpq_t radius,
                           const fmpq_t height) {
    LOCAL_VEC(fmpq, low, 7);
    fmpq *high = low + 3, *square = low + 6;
    scad_open(w, p, "intersection", '[');
    for (int i = 0; i < 3; i++) {
        fmpq_mul_2exp(high + i, radius, i < 2);
        fmpq_neg(low + i, high + i);
    }
    fmpq_add(low + 2, low + 2, height);
    fmpq_add(high + 2, high + 2, height);
    scad_put_box(w, p, low, high, 3);
    scad_open(w, p, "affine", '{');
    json_form(json_begin(&w->json, "matrix"),
              "[[\"1\",\"0\",\"0\",\"0\"],[\"0\",\"1\",\"0\",\"0\"],[\"0\",\"0\",\"1\",%]]",
              height);
    w->key = "of";
    scad_open(w, p, "polynomial", '{');
    fmpq_mul(square, radius, radius);
    fmpq_mul_si(square, square, -4);
    json_form(json_begin(&w->json, "4,0,0"),
              "\"1\",\"0,4,0\":\"1\",\"0,0,4\":\"1\",\"2,2,0\":\"2\",\"2,0,2\":\"2\","
              "\"0,2,2\":\"2\",\"2,0,0\":%,\"0,2,0\":%",
              square, square);
    scad_end(w, p);
    json_ends(&w->json, "}}]}");
}

/* A ball or a torus. */
static graze_status put_revolved(scad_writer *w, const scad_place *p, const fmpq_t radius) {
    const fmpq *x = w->map + 2, *height = w->map + 5;
    int torus = !fmpq_is_zero(x);
    if (torus && fmpq_equal(x, radius)) {
        put_horn_torus(w, p, radius, height);
        return GRAZE_OK;
    }
    if (torus && fmpq_cmp(x, radius) < 0)
        return scad_fail(p, GRAZE_EILLEGAL,
                         "the circle meets the axis about which it is revolved; expected its "
                         "centre on the axis, or none of it beyond the axis");
    scad_open(w, p, torus ? "torus" : "ball", '{');
    json_form(json_begin(&w->json, torus ? "point" : "center"), "[\"0\",\"0\",%]", height);
    if (torus)
        json_form(json_begin(&w->json, "axis"), "[\"0\",\"0\",\"1\"],\"major\":%", x);
    json_rational(&w->json, torus ? "minor" : "radius", radius);
    scad_end(w, p);
    return GRAZE_OK;
}

static graze_status read_circle(fmpq_t radius, scad_writer *w, const scad_place *p) {
    TRY(scad_known(p, "r"));
    TRY(scad_size(radius, p, "r"));
    fmpq_set(w->reach, radius);
    return map_radius(radius, w, p);
}

static graze_status write_circle(scad_writer *w, const scad_place *p) {
    LOCAL(fmpq, radius);
    TRY(read_circle(radius, w, p));
    if (w->form == SCAD_REVOLVED)
        return put_revolved(w, p, radius);
    if (w->form == SCAD_PRISM) {
        LOCAL_VEC(fmpq, ring, 4);
        if (!fmpq_equal(w->scale, w->scale + 1))
            return scad_fail(p, GRAZE_EINPUT,
                             "extruded with two scales; expected one, or a number of sides");
        fmpq_set(ring, radius);
        fmpq_mul(ring + 2, radius, w->scale);
        for (int k = 0; k < 2; k++)
            fmpq_set(ring + 2 * k + 1, w->height + k);
        scad_put_cylinder(w, p, ring);
        return GRAZE_OK;
    }
    scad_open(w, p, "ball", '{');
    json_rational(&w->json, "radius", radius);
    scad_end(w, p);
    return GRAZE_OK;
}

graze_status scad_outline_extent(fmpq *low_high, scad_writer *w, const scad_place *p) {
    HELD(scad_shape, r);
    fmpq *low = low_high, *high = low_high + 1;
    size_t sides = 1;
    if (p->file->node[p->node].role == SCAD_CIRCLE)
        TRY(scad_sides(&sides, w, p));
    if (sides == 0) {
        TRY(read_circle(high, w, p));
        fmpq_sub(low, w->map + 2, high);
        fmpq_add(high, w->map + 2, high);
        return GRAZE_OK;
    }
    TRY(read_rings(&r, w, p));
    for (size_t k = 0; k < r.points.count; k++) {
        const fmpq *x = r.points.at + 3 * k;
        if (k == 0 || fmpq_cmp(x, low) < 0)
            fmpq_set(low, x);
        if (k == 0 || fmpq_cmp(x, high) > 0)
            fmpq_set(high, x);
    }
    return GRAZE_OK;
}

graze_status scad_write_outline(scad_writer *w, const scad_place *p) {
    scad_role role = p->file->node[p->node].role;
    if (role == SCAD_SQUARE && w->form != SCAD_REVOLVED && !scad_is_tapered(w))
        return write_square(w, p);
    size_t sides = 0;
    if (role == SCAD_CIRCLE)
        TRY(scad_sides(&sides, w, p));
    return role == SCAD_CIRCLE && sides == 0 ? write_circle(w, p) : write_polygon(w, p);
}
