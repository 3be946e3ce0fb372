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

/* Write a cylinder, or a cone whose apex is above if its first radius is greater. `ring` has
 * radius and height of the bottom and of the top. */
static void put_cylinder(scad_writer *w, const scad_place *p, const fmpq *height,
                         const fmpq *ring) {
    LOCAL_VEC(fmpq, v, 5);
    fmpq *point = v, *slope = v + 1, *axis = v + 2, *end = v + 3;
    int order = fmpq_cmp(ring, ring + 2), up = order > 0;
    fmpq_set_si(axis, up ? -1 : 1, 1);
    fmpq_set(point, ring + 1);
    fmpq_set(end + 1, height);
    if (order != 0) {
        /* The apex is where the radius, which falls by `slope`, is 0. */
        fmpq_sub(slope, ring, ring + 2);
        fmpq_div(slope, slope, height);
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
        put_cylinder(w, p, height, ring);
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
