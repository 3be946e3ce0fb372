/* Hulls and Minkowski sums of the parts of a node, by their meshes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpq_vec.h>
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "input/csg/csg.h"
#include "input/planar/planar.h"
#include "input/scad/hull.h"

/* Whether the planes, or lines, of all facets have no vertex beyond them. */
static int is_convex(const soup *s) {
    int d = s->dimension;
    LOCAL_VEC(fmpq, n, 8);
    for (size_t c = 0; c < s->cycle_count; c++) {
        size_t begin = s->cycle_start[c], count = s->cycle_start[c + 1] - begin;
        const fmpq *first = s->coordinates + (size_t)d * s->index[begin];
        for (int i = 0; i < 3; i++)
            fmpq_zero(n + i);
        for (size_t k = 0; k < count; k++) {
            const fmpq *a = s->coordinates + (size_t)d * s->index[begin + k];
            const fmpq *b = s->coordinates + (size_t)d * s->index[begin + (k + 1) % count];
            if (d == 2) {
                fmpq_sub(n, b + 1, a + 1);
                fmpq_sub(n + 1, a, b);
                first = a;
            } else {
                vector_cross(n + 3, a, b);
                vector_add(n, n, n + 3, 3);
            }
            for (size_t v = 0; v < s->vertex_count && (d == 2 || k + 1 == count); v++) {
                _fmpq_vec_dot(n + 6, n, first, d);
                _fmpq_vec_dot(n + 7, n, s->coordinates + (size_t)d * v, d);
                if (fmpq_cmp(n + 7, n + 6) > 0)
                    return 0;
            }
        }
    }
    return 1;
}

/* Append the vertices of a mesh to points. */
static graze_status add_mesh_points(hull_points *out, graze_context *context, const soup *s) {
    LOCAL_VEC(fmpq, x, 3);
    for (size_t v = 0; v < s->vertex_count; v++) {
        vector_set(x, s->coordinates + v * (size_t)s->dimension, s->dimension);
        TRY(hull_add_point(out, context, x, "the points of a hull"));
    }
    return GRAZE_OK;
}

/* Append the vertices of a part, which is written as a solid of its own; none if it is empty. */
static graze_status part_points(hull_points *out, scad_writer *w, const scad_place *p, size_t part,
                                int convex) {
    HELD(text, t);
    ZEROED(csg, solid);
    HELD(soup, mesh, 3);
    csg_form form = CSG_CURVED;
    TRY(w->part(&t, w, part));
    if (t.failed)
        return context_fail(w->context, GRAZE_ESYSTEM, "out of memory for a solid");
    TRY(csg_read_text(&solid, w->context, w->file->source, t.data, t.length));
    if (!flat_surfaces(&solid))
        return scad_fail(p, GRAZE_EINPUT,
                         "only flat parts are taken; expected cubes, polyhedra, squares and "
                         "polygons in it");
    TRY(planar_soup(&mesh, &form, w->context, &solid));
    if (convex && !is_convex(&mesh))
        return scad_fail(p, GRAZE_EINPUT,
                         "only convex parts are taken; expected none with a notch or a hole");
    return add_mesh_points(out, w->context, &mesh);
}

static graze_status find_hull(hull_points *points, hull_faces *faces, scad_writer *w,
                              const scad_place *p) {
    if (points->count == 0)
        return scad_fail(p, GRAZE_EILLEGAL, "its parts are empty; expected one with an interior");
    faces->count = 0;
    return p->file->node[p->node].dimension == 2 ? hull_of_plane(points, w->context)
                                                 : hull_of_space(faces, points, w->context);
}

/* Replace `sum` by the points that are sums of one of it and one of `part`. */
static graze_status add_sums(hull_points *sum, graze_context *context, const hull_points *part) {
    ZEROED(hull_points, made);
    LOCAL_VEC(fmpq, x, 3);
    for (size_t k = 0; k < sum->count * part->count; k++) {
        vector_add(x, sum->at + 3 * (k / part->count), part->at + 3 * (k % part->count), 3);
        TRY(hull_add_point(&made, context, x, "the points of a hull"));
        if (made.count > context->limits[GRAZE_LIMIT_CELLS])
            return context_limit(context, GRAZE_LIMIT_CELLS, "points of a Minkowski sum");
    }
    hull_points_swap(sum, &made);
    return GRAZE_OK;
}

graze_status scad_hull(hull_points *points, hull_faces *faces, scad_writer *w,
                       const scad_place *p) {
    const scad *file = p->file;
    int sum = file->node[p->node].role == SCAD_MINKOWSKI;
    for (size_t c = scad_first(file, p->node); c; c = scad_next(file, c)) {
        ZEROED(hull_points, part);
        int first = points->count == 0;
        if (file->node[c].empty)
            continue;
        TRY(part_points(first || !sum ? points : &part, w, p, c, sum));
        if (part.count > 0)
            TRY(add_sums(points, w->context, &part));
        if (points->count > 0 && sum)
            TRY(find_hull(points, faces, w, p));
    }
    return find_hull(points, faces, w, p);
}
