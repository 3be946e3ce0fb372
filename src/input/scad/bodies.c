/* Writes primitives of space.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "input/csg/csg.h"
#include "input/scad/hull.h"

static graze_status write_cube(scad_writer *w, const scad_place *p) {
    LOCAL_VEC(fmpq, low, 6);
    fmpq *high = low + 3;
    TRY(scad_box(low, high, w, p, 3));
    scad_put_box(w, p, low, high, 3);
    return GRAZE_OK;
}

/* Write the polyhedron that OpenSCAD makes of a sphere: rings halfway between equal angles. */
static void put_sided_sphere(scad_writer *w, const scad_place *p, size_t sides) {
    size_t rings = (sides + 1) / 2;
    LOCAL_VEC(fmpq, ring, (slong)(2 * rings));
    for (size_t k = 0; k < rings; k++) {
        scad_corner(ring + 2 * k, 2 * (rings - k) - 1, 4 * rings, w->reach);
        fmpq_swap(ring + 2 * k, ring + 2 * k + 1);
    }
    scad_put_rings(w, p, ring, rings, sides);
}

static graze_status write_sphere(scad_writer *w, const scad_place *p) {
    size_t sides;
    TRY(scad_known(p, "r"));
    TRY(scad_sides(&sides, w, p));
    TRY(scad_size(w->reach, p, "r"));
    if (sides > 0) {
        put_sided_sphere(w, p, sides);
        return GRAZE_OK;
    }
    scad_open(w, p, "ball", '{');
    json_rational(&w->json, "radius", w->reach);
    scad_end(w, p);
    return GRAZE_OK;
}

void scad_put_cylinder(scad_writer *w, const scad_place *p, const fmpq *ring) {
    LOCAL_VEC(fmpq, v, 5);
    /* A cone's apex is above if its first radius is greater. */
    fmpq *point = v, *slope = v + 1, *axis = v + 2, *end = v + 3;
    int order = fmpq_cmp(ring, ring + 2), up = order > 0;
    fmpq_set_si(axis, up ? -1 : 1, 1);
    fmpq_set(point, ring + 1);
    fmpq_sub(end + 1, ring + 3, ring + 1);
    if (order != 0) {
        /* The apex is where the radius, which falls by `slope`, is 0. */
        fmpq_sub(slope, ring, ring + 2);
        fmpq_div(slope, slope, end + 1);
        fmpq_div(end, ring, slope);
        fmpq_add(point, point, end);
        fmpq_abs(slope, slope);
        fmpq_div(end, ring, slope);
        fmpq_div(end + 1, ring + 2, slope);
    }
    scad_open(w, p, order ? "cone" : "cylinder", '{');
    json_form(json_begin(&w->json, "point"), "[\"0\",\"0\",%],\"axis\":[\"0\",\"0\",%]", point,
              axis);
    json_rational(&w->json, order ? "slope" : "radius", order ? slope : ring);
    json_rational(&w->json, "from", end + up);
    json_rational(&w->json, "to", end + 1 - up);
    scad_end(w, p);
}

static graze_status write_cylinder(scad_writer *w, const scad_place *p) {
    LOCAL_VEC(fmpq, ring, 5);
    fmpq *height = ring + 4, *low = ring + 1;
    TRY(scad_known(p, "h r1 r2 center"));
    size_t sides;
    TRY(scad_sides(&sides, w, p));
    TRY(scad_size(height, p, "h"));
    TRY(scad_named_number(ring, p, "r1"));
    TRY(scad_named_number(ring + 2, p, "r2"));
    const fmpq *most = fmpq_cmp(ring, ring + 2) < 0 ? ring + 2 : ring;
    fmpq_add(w->reach, height, most);
    if (scad_flag(p, "center"))
        fmpq_div_2exp(low, height, 1);
    fmpq_neg(low, low);
    fmpq_add(ring + 3, low, height);
    if (sides > 0)
        scad_put_rings(w, p, ring, 2, sides);
    else
        scad_put_cylinder(w, p, ring);
    return GRAZE_OK;
}

/* Write a face, the numbers of its points. */
static graze_status put_face(scad_writer *w, const scad_place *p, field face, size_t count) {
    field rest, item;
    TRY(scad_list(&rest, p, face));
    json_open(&w->json, NULL, '[');
    while (scad_item(&item, &rest)) {
        size_t k;
        TRY(scad_index(&k, p, item, count));
        json_count(&w->json, NULL, k);
    }
    json_close(&w->json, ']');
    return GRAZE_OK;
}

static graze_status write_polyhedron(scad_writer *w, const scad_place *p) {
    field points, faces, item;
    LOCAL_VEC(fmpq, x, 3);
    size_t count = 0;
    TRY(scad_known(p, "points faces convexity"));
    TRY(scad_named_list(&points, p, "points"));
    TRY(scad_named_list(&faces, p, "faces"));
    scad_open(w, p, "polyhedron", '{');
    json_open(&w->json, "points", '[');
    for (; scad_item(&item, &points); count++) {
        TRY(scad_vector(x, p, item, 3));
        json_point(&w->json, NULL, x, 3);
        scad_hold(w->reach, x, 3);
    }
    json_close(&w->json, ']');
    json_open(&w->json, "faces", '[');
    while (scad_item(&item, &faces))
        TRY(put_face(w, p, item, count));
    json_close(&w->json, ']');
    scad_end(w, p);
    return GRAZE_OK;
}

/* Write the points over, under and in a convex polygon, within `radius` of its plane: in the frame
 * of its first edge u, of n x u and of its normal n, with corner 0 as the origin. */
static graze_status put_plate(scad_writer *w, const scad_place *p, scad_shape *s,
                              const fmpq_t radius) {
    const fmpq *corner = s->points.at;
    LOCAL_VEC(fmpq, frame, 18);
    fmpq *from = frame + 12, *height = frame + 15, *square = frame + 17;
    TRY(numbers_add(&s->end, w->context, s->points.count, "the points of a polygon"));
    vector_sub(frame, corner + 3, corner, 3);
    vector_sub(from, corner + 6, corner, 3);
    vector_cross(frame + 6, frame, from);
    vector_cross(frame + 3, frame + 6, frame);
    vector_set(frame + 9, corner, 3);
    _fmpq_vec_dot(square, frame + 6, frame + 6, 3);
    fmpq_div(square, radius, square);
    fmpq_mul(square, square, radius);
    csg_upper_root(height + 1, square);
    fmpq_neg(height, height + 1);
    fmpq_neg(square, square);
    scad_put_frame(w, p, frame);
    scad_open(w, p, "intersection", '[');
    scad_put_prism(w, p, frame, s, height);
    scad_open(w, p, "quadric", '{');
    json_form(json_begin(&w->json, "0,0,2"), "\"1\",\"0,0,0\":%", square);
    scad_end(w, p);
    json_ends(&w->json, "]}}}");
    return GRAZE_OK;
}

graze_status scad_put_segment(scad_writer *w, const scad_place *p, const fmpq *a, const fmpq *b,
                              const fmpq_t radius) {
    int d = w->form == SCAD_PRISM ? 2 : w->dimension, same = vector_compare(a, b, d) == 0;
    HELD(scad_shape, side);
    LOCAL_VEC(fmpq, x, 3);
    if (w->form != SCAD_PRISM) {
        scad_open(w, p, same ? "ball" : "capsule", '{');
        json_point(&w->json, same ? "center" : "point", a, d);
        vector_sub(x, b, a, d);
        if (!same)
            json_point(&w->json, "axis", x, d);
        json_rational(&w->json, "radius", radius);
        scad_end(w, p);
        return GRAZE_OK;
    }
    fmpq_sub(x, w->height + 1, w->height);
    scad_open(w, p, "cylinder", '{');
    json_form(json_begin(&w->json, "point"),
              "[%,%,%],\"axis\":[\"0\",\"0\",%],\"radius\":%,\"from\":0,\"to\":1", a, a + 1,
              w->height, x, radius);
    scad_end(w, p);
    for (int k = 0; k < 4; k++) {
        vector_set(x, k == 0 || k == 3 ? a : b, 2);
        fmpq_set(x + 2, w->height + k / 2);
        TRY(hull_add_point(&side.points, w->context, x, "the points of a hull"));
    }
    return same ? GRAZE_OK : put_plate(w, p, &side, radius);
}

/* Write the points within the radius of a hull: its own, and those of its faces and edges, but of
 * no edge between faces in one plane. */
static graze_status put_round_hull(scad_writer *w, const scad_place *p, const scad_shape *s) {
    const hull_points *all = &s->points;
    if (s->faces.count == 0)
        return scad_put_segment(w, p, all->at, all->at + 3 * (all->count - 1), s->radius);
    scad_open(w, p, "union", '[');
    scad_put_hull(w, p, s);
    for (size_t k = 0; k < 3 * s->faces.count; k++) {
        const size_t *corner = s->faces.item[k / 3].corner, a = corner[k % 3];
        const size_t b = corner[(k + 1) % 3];
        HELD(scad_shape, face);
        for (int i = 0; i < 3 && k % 3 == 0; i++)
            TRY(hull_add_point(&face.points, w->context, all->at + 3 * corner[i],
                               "a face of a hull"));
        if (k % 3 == 0)
            TRY(put_plate(w, p, &face, s->radius));
        for (size_t i = 0; i < 3 * s->faces.count && a < b; i++) {
            const size_t *other = s->faces.item[i / 3].corner;
            if (other[i % 3] == b && other[(i + 1) % 3] == a &&
                hull_side(all, corner, other[(i + 2) % 3]) != 0)
                TRY(scad_put_segment(w, p, all->at + 3 * a, all->at + 3 * b, s->radius));
        }
        TRY(context_work(w->context, 4 * s->faces.count));
    }
    json_ends(&w->json, "]}");
    return GRAZE_OK;
}

static graze_status write_hull(scad_writer *w, const scad_place *p) {
    HELD(scad_shape, s);
    TRY(scad_hull(&s, w, p));
    if (s.notched.vertex_count > 0)
        return scad_put_sum(w, p, &s);
    for (size_t k = 0; k < s.points.count; k++)
        scad_hold(w->reach, s.points.at + 3 * k, 3);
    fmpq_add(w->reach, w->reach, s.radius);
    if (!fmpq_is_zero(s.radius))
        return put_round_hull(w, p, &s);
    scad_put_hull(w, p, &s);
    return GRAZE_OK;
}

graze_status scad_write_body(scad_writer *w, const scad_place *p) {
    static graze_status (*const writers[])(scad_writer *, const scad_place *) = {
        write_cube, write_sphere, write_cylinder, write_polyhedron};
    scad_role role = p->file->node[p->node].role;
    return role < SCAD_CUBE ? write_hull(w, p) : writers[role - SCAD_CUBE](w, p);
}
