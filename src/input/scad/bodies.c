/* Writes primitives of space.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpq_vec.h>
#include "base/context/scope.h"
#include "input/scad/arguments.h"
#include "input/scad/hull.h"
#include "input/scad/writer.h"

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

/* Write a cylinder, or a cone whose apex is above if its first radius is greater. `low` is the
 * height of the bottom. */
static void put_cylinder(scad_writer *w, const scad_place *p, const fmpq *height, const fmpq *low,
                         const fmpq *radius) {
    LOCAL_VEC(fmpq, v, 5);
    fmpq *point = v, *slope = v + 1, *axis = v + 2, *end = v + 3;
    int order = fmpq_cmp(radius, radius + 1), up = order > 0;
    fmpq_set_si(axis, up ? -1 : 1, 1);
    fmpq_set(point, low);
    fmpq_set(end + 1, height);
    if (order != 0) {
        /* The apex is where the radius, which falls by `slope`, is 0. */
        fmpq_sub(slope, radius, radius + 1);
        fmpq_div(slope, slope, height);
        fmpq_div(end, radius, slope);
        fmpq_add(point, low, end);
        fmpq_abs(slope, slope);
        fmpq_div(end, radius, slope);
        fmpq_div(end + 1, radius + 1, slope);
    }
    scad_open(w, p, order ? "cone" : "cylinder", '{');
    json_form(json_begin(&w->json, "point"), "[\"0\",\"0\",%],\"axis\":[\"0\",\"0\",%]", point,
              axis);
    json_rational(&w->json, order ? "slope" : "radius", order ? slope : radius);
    json_rational(&w->json, "from", end + up);
    json_rational(&w->json, "to", end + 1 - up);
    scad_end(w, p);
}

static void put_sided_cylinder(scad_writer *w, const scad_place *p, const fmpq *height,
                               const fmpq *low, const fmpq *radius, size_t sides) {
    LOCAL_VEC(fmpq, ring, 4);
    fmpq_set(ring, radius);
    fmpq_set(ring + 1, low);
    fmpq_set(ring + 2, radius + 1);
    fmpq_add(ring + 3, low, height);
    scad_put_rings(w, p, ring, 2, sides);
}

static graze_status write_cylinder(scad_writer *w, const scad_place *p) {
    LOCAL_VEC(fmpq, v, 4);
    fmpq *height = v, *low = v + 1, *radius = v + 2;
    TRY(scad_known(p, "h r1 r2 center"));
    size_t sides;
    TRY(scad_sides(&sides, w, p));
    TRY(scad_size(height, p, "h"));
    TRY(scad_named_number(radius, p, "r1"));
    TRY(scad_named_number(radius + 1, p, "r2"));
    const fmpq *most = fmpq_cmp(radius, radius + 1) < 0 ? radius + 1 : radius;
    fmpq_add(w->reach, height, most);
    if (scad_flag(p, "center"))
        fmpq_div_2exp(low, height, 1);
    fmpq_neg(low, low);
    if (sides > 0)
        put_sided_cylinder(w, p, height, low, radius, sides);
    else
        put_cylinder(w, p, height, low, radius);
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

static graze_status write_hull(scad_writer *w, const scad_place *p) {
    ZEROED(hull_points, points);
    ZEROED(hull_faces, faces);
    TRY(scad_known(p, "convexity"));
    TRY(scad_hull(&points, &faces, w, p));
    scad_open(w, p, "polyhedron", '{');
    json_open(&w->json, "points", '[');
    for (size_t k = 0; k < points.count; k++) {
        json_point(&w->json, NULL, points.at + 3 * k, 3);
        scad_hold(w->reach, points.at + 3 * k, 3);
    }
    json_close(&w->json, ']');
    json_open(&w->json, "faces", '[');
    for (size_t k = 0; k < faces.count; k++) {
        json_open(&w->json, NULL, '[');
        for (int i = 0; i < 3; i++)
            json_count(&w->json, NULL, faces.item[k].corner[i]);
        json_close(&w->json, ']');
    }
    json_close(&w->json, ']');
    scad_end(w, p);
    return GRAZE_OK;
}

graze_status scad_write_body(scad_writer *w, const scad_place *p) {
    static graze_status (*const writers[])(scad_writer *, const scad_place *) = {
        write_cube, write_sphere, write_cylinder, write_polyhedron};
    scad_role role = p->file->node[p->node].role;
    return role < SCAD_CUBE ? write_hull(w, p) : writers[role - SCAD_CUBE](w, p);
}
