/* Hulls, Minkowski sums and offsets of the parts of a node, by their meshes, centres and radii.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
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

void scad_shape_init(scad_shape *s) {
    *s = (scad_shape){.points.count = 0};
    fmpq_init(s->radius);
}

void scad_shape_clear(scad_shape *s) {
    hull_points_clear(&s->points);
    hull_faces_clear(&s->faces);
    numbers_clear(&s->end);
    fmpq_clear(s->radius);
}

/* Read a part, or with `inner` the union of the node's children, as a solid of its own; `mesh` is
 * that of a flat one. */
static graze_status read_round_part(csg *solid, soup *mesh, scad_writer *w, const scad_place *p,
                                    size_t part, int inner) {
    HELD(text, t);
    csg_form form = CSG_CURVED;
    TRY(w->part(&t, w, part, inner));
    if (t.failed)
        return context_fail(w->context, GRAZE_ESYSTEM, "out of memory for a solid");
    TRY(csg_read_text(solid, w->context, w->file->source, t.data, t.length));
    if (flat_surfaces(solid))
        return planar_soup(mesh, &form, w->context, solid);
    if (solid->round_count == 0 || solid->not_round)
        return scad_fail(p, GRAZE_EINPUT,
                         "only flat parts are taken, or balls or disks; expected cubes, polyhedra, "
                         "squares and polygons in it");
    return GRAZE_OK;
}

/* Append the vertices of a mesh to points, in the plane in the order of its rings, whose ends are
 * kept where `end` is given. */
static graze_status add_mesh_points(hull_points *out, numbers *end, graze_context *context,
                                    const soup *s) {
    size_t d = (size_t)s->dimension, rings = d == 2 ? s->cycle_count : 1;
    LOCAL_VEC(fmpq, x, 3);
    for (size_t c = 0; c < rings; c++) {
        size_t from = d == 2 ? s->cycle_start[c] : 0;
        size_t to = d == 2 ? s->cycle_start[c + 1] : s->vertex_count;
        for (size_t k = from; k < to; k++) {
            vector_set(x, s->coordinates + d * (d == 2 ? s->index[k] : k), s->dimension);
            TRY(hull_add_point(out, context, x, "the points of a hull"));
        }
        if (end)
            TRY(numbers_add(end, context, out->count, "the rings of a polygon"));
    }
    return GRAZE_OK;
}

/* Append the centres of balls to points, and take over their radius; to a sum it is added. */
static graze_status add_centers(hull_points *out, fmpq_t radius, const scad_place *p, const csg *s,
                                int sum) {
    for (size_t k = 0; k < s->round_count; k++) {
        const csg_round *ball = &s->round[k];
        int first = fmpq_is_zero(radius) && out->count == 0;
        if (sum ? s->round_count > 1 || ball->ends > 1
                : !first && !fmpq_equal(radius, ball->radius))
            return scad_fail(p, GRAZE_EINPUT,
                             sum ? "of round parts only balls and disks are taken; expected one in "
                                   "each"
                                 : "round parts are taken if all are balls or disks of one radius; "
                                   "expected those alone");
        if (sum || first)
            fmpq_add(radius, radius, ball->radius);
        for (int i = 0; i < ball->ends; i++)
            TRY(hull_add_point(out, p->context, ball->end + 3 * i, "the points of a hull"));
    }
    return GRAZE_OK;
}

static graze_status find_hull(scad_shape *s, const scad_place *p) {
    const scad_node *n = &p->file->node[p->node];
    s->faces.count = 0;
    return context_in(p->context,
                      n->dimension == 2 ? hull_of_plane(&s->points, p->context)
                                        : hull_of_space(&s->faces, &s->points, p->context),
                      p->file->source, n->line);
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

/* Add a part to a hull or a sum. In the plane one part of a sum may have notches and holes, if the
 * others are disks; `flat` counts the others. */
static graze_status add_summand(scad_shape *out, size_t *flat, scad_writer *w, const scad_place *p,
                                size_t part, int inner) {
    ZEROED(csg, solid);
    ZEROED(hull_points, points);
    HELD(soup, mesh, 3);
    int sum = p->file->node[p->node].role != SCAD_HULL;
    TRY(read_round_part(&solid, &mesh, w, p, part, inner));
    if (solid.round_count > 0)
        TRY(add_centers(sum ? &points : &out->points, out->radius, p, &solid, sum));
    else if (!sum && mesh.vertex_count > 0 && !fmpq_is_zero(out->radius))
        return scad_fail(p, GRAZE_EINPUT,
                         "flat and round parts are not taken together; expected one kind");
    int notched = sum && mesh.vertex_count > 0 && !is_convex(&mesh);
    if (mesh.vertex_count > 0 &&
        ((notched && (mesh.dimension == 3 || *flat > 0)) || out->end.count > 0))
        return scad_fail(p, GRAZE_EINPUT,
                         "only convex parts are taken; expected none with a notch or a hole");
    *flat += mesh.vertex_count > 0;
    TRY(add_mesh_points(sum ? &points : &out->points, notched ? &out->end : NULL, w->context,
                        &mesh));
    if (!sum || points.count == 0)
        return GRAZE_OK;
    if (out->points.count == 0)
        hull_points_swap(&out->points, &points);
    else
        TRY(add_sums(&out->points, w->context, &points));
    return out->end.count == 0 ? find_hull(out, p) : GRAZE_OK;
}

graze_status scad_hull(scad_shape *out, scad_writer *w, const scad_place *p) {
    const scad *file = p->file;
    int offset = file->node[p->node].role == SCAD_OFFSET;
    size_t flat = 0, c = offset ? p->node : scad_first(file, p->node);
    LOCAL(fmpq, more);
    field value;
    TRY(scad_known(p, offset ? "r delta chamfer" : "convexity"));
    if (scad_flag(p, "chamfer"))
        return scad_fail(p, GRAZE_EINPUT, "expected chamfer = false");
    for (; c; c = offset ? 0 : scad_next(file, c))
        if (!file->node[c].empty)
            TRY(add_summand(out, &flat, w, p, c, offset));
    out->mitred = offset && flat > 0 && scad_value(&value, p, "delta");
    if (offset)
        TRY(scad_named_number(more, p, scad_value(&value, p, "delta") ? "delta" : "r"));
    fmpq_add(out->radius, out->radius, more);
    if (out->points.count == 0 || (fmpq_sgn(out->radius) <= 0 && flat == 0))
        return scad_fail(p, GRAZE_EILLEGAL, "its parts are empty; expected one with an interior");
    if (out->end.count > 0)
        return GRAZE_OK;
    TRY(find_hull(out, p));
    return numbers_add(&out->end, w->context, out->points.count, "the rings of a polygon");
}
