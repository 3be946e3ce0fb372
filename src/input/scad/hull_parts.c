/* Hulls, Minkowski sums and offsets of the parts of a node, by their meshes, centres and radii.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The sum of a part A with notches and a convex B: if A meets x - B, then x - B is in A, and x in A
 * moved by any point of B, or x - B meets a facet of A. If it does not meet the facet's edges too,
 * it meets its plane inside the facet alone, where also each segment crosses that joins the points
 * of x - B which are furthest on both sides. So A moved, facets along such segments, and edges and
 * B are all of the sum.
 */
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "input/csg/csg.h"
#include "input/planar/planar.h"
#include "input/scad/hull.h"

/* Set n to a normal of a cycle in space, outwards. */
static void cycle_normal(fmpq *n, const soup *s, size_t cycle) {
    LOCAL_VEC(fmpq, part, 3);
    const uint32_t *corner = s->index + s->cycle_start[cycle];
    size_t count = s->cycle_start[cycle + 1] - s->cycle_start[cycle];
    for (int i = 0; i < 3; i++)
        fmpq_zero(n + i);
    for (size_t k = 0; k < count; k++) {
        vector_cross(part, s->coordinates + 3 * corner[k],
                     s->coordinates + 3 * corner[(k + 1) % count]);
        vector_add(n, n, part, 3);
    }
}

/* Whether the planes, or lines, of all facets have no vertex beyond them. */
static int is_convex(const soup *s) {
    size_t d = (size_t)s->dimension;
    LOCAL_VEC(fmpq, n, 5);
    for (size_t c = 0; c < s->cycle_count; c++) {
        size_t begin = s->cycle_start[c], end = s->cycle_start[c + 1];
        for (size_t k = begin; k < (d == 3 ? begin + 1 : end); k++) {
            const fmpq *a = s->coordinates + d * s->index[k];
            const fmpq *b = s->coordinates + d * s->index[k + 1 < end ? k + 1 : begin];
            if (d == 3) {
                cycle_normal(n, s, c);
            } else {
                fmpq_sub(n, b + 1, a + 1);
                fmpq_sub(n + 1, a, b);
            }
            for (size_t v = 0; v < s->vertex_count; v++) {
                _fmpq_vec_dot(n + 3, n, a, (slong)d);
                _fmpq_vec_dot(n + 4, n, s->coordinates + d * v, (slong)d);
                if (fmpq_cmp(n + 4, n + 3) > 0)
                    return 0;
            }
        }
    }
    return 1;
}

void scad_shape_init(scad_shape *s) {
    *s = (scad_shape){.points.count = 0};
    fmpq_init(s->radius);
    soup_init(&s->notched, 3);
}

void scad_shape_clear(scad_shape *s) {
    hull_points_clear(&s->points);
    hull_faces_clear(&s->faces);
    numbers_clear(&s->end);
    fmpq_clear(s->radius);
    soup_clear(&s->notched);
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

/* Add a part to a hull or a sum; one of a sum may have notches and holes. `flat` counts the flat
 * ones. */
static graze_status add_summand(scad_shape *out, size_t *flat, scad_writer *w, const scad_place *p,
                                size_t part, int inner) {
    ZEROED(csg, solid);
    ZEROED(hull_points, points);
    HELD(soup, mesh, 3);
    int sum = p->file->node[p->node].role != SCAD_HULL;
    TRY(read_round_part(&solid, &mesh, w, p, part, inner));
    *flat += mesh.vertex_count > 0;
    if (solid.round_count > 0)
        TRY(add_centers(sum ? &points : &out->points, out->radius, p, &solid, sum));
    else if (!sum && mesh.vertex_count > 0 && !fmpq_is_zero(out->radius))
        return scad_fail(p, GRAZE_EINPUT,
                         "flat and round parts are not taken together; expected one kind");
    if (sum && mesh.vertex_count > 0 && !is_convex(&mesh)) {
        soup held = out->notched;
        out->notched = mesh;
        mesh = held;
        if (mesh.vertex_count > 0)
            return scad_fail(p, GRAZE_EINPUT,
                             "two parts have notches or holes; expected one such part at most");
        return GRAZE_OK;
    }
    TRY(add_mesh_points(sum ? &points : &out->points, NULL, w->context, &mesh));
    if (!sum || points.count == 0)
        return GRAZE_OK;
    if (out->points.count == 0)
        hull_points_swap(&out->points, &points);
    else
        TRY(add_sums(&out->points, w->context, &points));
    return find_hull(out, p);
}

/* Take the notched part as the rings of an outline if disks alone are added to it; it stays where
 * the hull of a flat part is added. */
static graze_status take_notched(scad_shape *s, const scad_place *p) {
    ZEROED(hull_points, rings);
    LOCAL_VEC(fmpq, origin, 3);
    if (s->points.count == 0)
        TRY(hull_add_point(&s->points, p->context, origin, "the points of a hull"));
    if (s->points.count > 1 || s->notched.dimension == 3)
        return fmpq_is_zero(s->radius)
                   ? GRAZE_OK
                   : scad_fail(p, GRAZE_EINPUT,
                               "of a part with a notch or a hole, with balls or with disks and "
                               "flat parts; expected flat parts alone, in the plane or disks");
    TRY(add_mesh_points(&rings, &s->end, p->context, &s->notched));
    TRY(add_sums(&rings, p->context, &s->points));
    hull_points_swap(&s->points, &rings);
    soup_clear(&s->notched);
    return GRAZE_OK;
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
    if (fmpq_sgn(out->radius) <= 0 && flat == 0)
        return scad_fail(p, GRAZE_EILLEGAL, "its parts are empty; expected one with an interior");
    if (out->notched.vertex_count > 0)
        return take_notched(out, p);
    TRY(find_hull(out, p));
    return numbers_add(&out->end, w->context, out->points.count, "the rings of a polygon");
}

/* Write the notched part, moved by the first point of the hull. */
static graze_status put_notched(scad_writer *w, const scad_place *p, const scad_shape *s) {
    const soup *a = &s->notched;
    HELD(scad_shape, moved);
    ZEROED(hull_points, by);
    TRY(hull_add_point(&by, w->context, s->points.at, "the points of a sum"));
    TRY(add_mesh_points(&moved.points, a->dimension == 2 ? &moved.end : NULL, w->context, a));
    TRY(add_sums(&moved.points, w->context, &by));
    if (a->dimension == 2) {
        scad_put_polygon(w, p, &moved);
        return GRAZE_OK;
    }
    scad_open(w, p, "polyhedron", '{');
    json_open(&w->json, "points", '[');
    for (size_t k = 0; k < moved.points.count; k++)
        json_point(&w->json, NULL, moved.points.at + 3 * k, 3);
    json_close(&w->json, ']');
    json_open(&w->json, "faces", '[');
    for (size_t c = 0; c < a->cycle_count; c++) {
        json_open(&w->json, NULL, '[');
        for (size_t k = a->cycle_start[c]; k < a->cycle_start[c + 1]; k++)
            json_count(&w->json, NULL, a->index[k]);
        json_close(&w->json, ']');
    }
    json_close(&w->json, ']');
    scad_end(w, p);
    return GRAZE_OK;
}

/* Write the sum of an edge and the hull. */
static graze_status put_edge_sum(scad_writer *w, const scad_place *p, const scad_shape *s,
                                 const size_t *end) {
    size_t d = (size_t)s->notched.dimension;
    HELD(scad_shape, sum);
    LOCAL_VEC(fmpq, x, 3);
    for (int k = 0; k < 2; k++) {
        vector_set(x, s->notched.coordinates + d * end[k], (int)d);
        TRY(hull_add_point(&sum.points, w->context, x, "the points of a sum"));
    }
    TRY(add_sums(&sum.points, w->context, &s->points));
    TRY(find_hull(&sum, p));
    TRY(numbers_add(&sum.end, w->context, sum.points.count, "the points of a sum"));
    (d == 2 ? scad_put_polygon : scad_put_hull)(w, p, &sum);
    return context_work(w->context, s->points.count);
}

/* Write the sum of a facet and the segment between the points of the hull that are lowest and
 * highest along its normal: a prism in the frame of an edge u, n x u and that segment. */
static graze_status put_facet_sum(scad_writer *w, const scad_place *p, const scad_shape *s,
                                  size_t facet) {
    const soup *a = &s->notched;
    const size_t begin = a->facet_start[facet], end = a->facet_start[facet + 1];
    const uint32_t *corner = a->index + a->cycle_start[begin];
    const fmpq *origin = a->coordinates + 3 * corner[0], *low = s->points.at, *high = low;
    HELD(scad_shape, outline);
    LOCAL_VEC(fmpq, frame, 21);
    fmpq *normal = frame + 12, *from = frame + 15, *height = frame + 18, *size = frame + 20;
    cycle_normal(normal, a, begin);
    for (size_t k = 0; k < s->points.count; k++) {
        const fmpq *point = s->points.at + 3 * k;
        vector_sub(from, point, low, 3);
        _fmpq_vec_dot(size, normal, from, 3);
        low = fmpq_sgn(size) < 0 ? point : low;
        vector_sub(from, point, high, 3);
        _fmpq_vec_dot(size, normal, from, 3);
        high = fmpq_sgn(size) > 0 ? point : high;
    }
    vector_sub(frame, a->coordinates + 3 * corner[1], origin, 3);
    vector_cross(frame + 3, normal, frame);
    vector_sub(frame + 6, high, low, 3);
    vector_add(frame + 9, origin, low, 3);
    for (size_t c = begin; c < end; c++) {
        for (size_t k = a->cycle_start[c]; k < a->cycle_start[c + 1]; k++)
            TRY(hull_add_point(&outline.points, w->context, a->coordinates + 3 * a->index[k],
                               "the points of a sum"));
        TRY(numbers_add(&outline.end, w->context, outline.points.count, "the rings of a facet"));
    }
    fmpq_one(height + 1);
    scad_put_frame(w, p, frame);
    scad_put_prism(w, p, frame, &outline, height);
    json_ends(&w->json, "}}");
    return GRAZE_OK;
}

graze_status scad_put_sum(scad_writer *w, const scad_place *p, const scad_shape *s) {
    const soup *a = &s->notched;
    LOCAL(fmpq, far);
    for (size_t k = 0; k < a->vertex_count; k++)
        scad_hold(w->reach, a->coordinates + (size_t)a->dimension * k, a->dimension);
    for (size_t k = 0; k < s->points.count; k++)
        scad_hold(far, s->points.at + 3 * k, 3);
    fmpq_add(w->reach, w->reach, far);
    scad_open(w, p, "union", '[');
    TRY(put_notched(w, p, s));
    for (size_t c = 0; c < a->cycle_count && s->points.count > 1; c++)
        for (size_t k = a->cycle_start[c]; k < a->cycle_start[c + 1]; k++) {
            size_t next = k + 1 < a->cycle_start[c + 1] ? k + 1 : a->cycle_start[c];
            size_t end[2] = {a->index[k], a->index[next]};
            if (a->dimension == 2 || end[0] < end[1])
                TRY(put_edge_sum(w, p, s, end));
        }
    for (size_t f = 0; f < a->facet_count && a->dimension == 3 && s->points.count > 1; f++)
        TRY(put_facet_sum(w, p, s, f));
    json_ends(&w->json, "]}");
    return GRAZE_OK;
}
