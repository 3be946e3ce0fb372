/* Polyhedra of curved solids, of half-spaces.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Faces are cut into fans of triangles. If no point is beyond the plane of a triangle, and each
 * edge of a face is also an edge of another face, in the other direction, then the triangles cover
 * the boundary of the hull of the points equally often everywhere, at least once: they lie in it,
 * face outward, and their sum has no boundary. So the hull is the intersection of the half-spaces
 * of the triangles.
 *
 * A point is in a polyhedron that is not convex iff the ray downwards from it crosses an odd number
 * of triangles, that is, iff it is in an odd number of the sets of points above a triangle,
 * between the vertical planes through its edges. Where such a plane is no boundary of the
 * polyhedron, its sign does not change the parity, since each edge is one of an even number of
 * triangles.
 */
#include "input/csg/csg_reader.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

/* An edge from point `low` to point `high`, or, if `back`, from `high` to `low`. */
typedef struct edge {
    size_t low, high;
    int back;
} edge;

typedef struct faces {
    csg_reader *r;
    const json *value; /* of the polyhedron */
    fmpq *point;       /* 3 each */
    size_t points;
    size_t *corner; /* of the face at hand */
    edge *edge;
    size_t edges;
    size_t *node, nodes;
    int side;    /* the side of all planes on which the points are; 0: not known yet */
    int notched; /* 1: there are points on both sides */
    fmpq *form;  /* 4: a plane n . x = c, and room for 6 more */
} faces;

static int edge_order(const void *left, const void *right) {
    const edge *a = left, *b = right;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    return a->high < b->high ? -1 : a->high > b->high;
}

/* The side of the plane f->form on which a point is; 0 if the point is in the plane. */
static int plane_side(const faces *f, size_t point) {
    fmpq *value = f->form + 4;
    _fmpq_vec_dot(value, f->form, f->point + 3 * point, 3);
    return fmpq_cmp(value, f->form + 3);
}

/* Set f->form to the plane of three points; returns 0 if they are on a line. */
static int set_plane(faces *f, size_t a, size_t b, size_t c) {
    fmpq *u = f->form + 4, *v = f->form + 7;
    vector_sub(u, f->point + 3 * b, f->point + 3 * a, 3);
    vector_sub(v, f->point + 3 * c, f->point + 3 * a, 3);
    vector_cross(f->form, u, v);
    _fmpq_vec_dot(f->form + 3, f->form, f->point + 3 * a, 3);
    return !vector_is_zero(f->form, 3);
}

/* Check that the corners of the face lie in the plane f->form, and note whether a point is on
 * another side of it than f->side, which is common to all planes of a convex polyhedron. */
static graze_status check_plane(faces *f, const json *face) {
    graze_context *context = f->r->context;
    for (size_t k = 0; k < face->count; k++)
        if (plane_side(f, f->corner[k]) != 0)
            return json_fail(context, GRAZE_EILLEGAL, face, "the face is not plane");
    for (size_t k = 0; k < f->points && !f->notched; k++) {
        int side = plane_side(f, k);
        f->side = f->side ? f->side : side;
        f->notched = side && side != f->side;
    }
    return context_work(context, 8 * f->points);
}

/* Add the half-space of the plane f->form that holds the points. */
static graze_status add_plane(faces *f) {
    csg_linear_form(f->r->f, f->r, f->form, f->r->coordinate, f->form + 3);
    return csg_add_side(&f->node[f->nodes++], f->r, f->side > 0);
}

static graze_status read_corners(faces *f, const json *face) {
    graze_context *context = f->r->context;
    LOCAL(fmpz, number);
    size_t k = 0;
    TRY(json_array(context, face, 0));
    if (face->count < 3)
        return json_fail(context, GRAZE_EINPUT, face, "expected at least 3 points, not %zu",
                         face->count);
    for (const json *item = face->first; item; item = item->next) {
        TRY(entry_integer(number, context, item));
        if (fmpz_sgn(number) < 0 || fmpz_cmp_ui(number, f->points) >= 0)
            return json_fail(context, GRAZE_EINPUT, item,
                             "expected the number of a point, below %zu", f->points);
        f->corner[k++] = fmpz_get_ui(number);
    }
    return GRAZE_OK;
}

static graze_status read_face(faces *f, const json *face) {
    TRY(read_corners(f, face));
    int found = 0;
    for (size_t k = 0; k < face->count; k++) {
        size_t a = f->corner[k], b = f->corner[(k + 1) % face->count];
        f->edge[f->edges++] = (edge){a < b ? a : b, a < b ? b : a, a > b};
    }
    for (size_t k = 1; k + 1 < face->count; k++) {
        if (!set_plane(f, f->corner[0], f->corner[k], f->corner[k + 1]))
            continue;
        TRY(check_plane(f, face));
        if (!found++)
            TRY(add_plane(f));
    }
    return GRAZE_OK;
}

/* Check that faces run through each edge as often in one direction as in the other. */
static graze_status check_closed(faces *f) {
    long sum = 0;
    qsort(f->edge, f->edges, sizeof *f->edge, edge_order);
    for (size_t k = 0; k < f->edges; k++) {
        const edge *e = &f->edge[k];
        sum += e->low == e->high ? 0 : e->back ? -1 : 1;
        if (sum && (k + 1 == f->edges || edge_order(e, e + 1) != 0))
            return json_fail(f->r->context, GRAZE_EILLEGAL, f->value,
                             "the edge of the points %zu and %zu is not one of two faces, in both "
                             "directions; expected a closed surface",
                             e->low, e->high);
    }
    if (f->nodes == 0 || !f->side)
        return json_fail(f->r->context, GRAZE_EILLEGAL, f->value, "the polyhedron has no interior");
    return GRAZE_OK;
}

/* Add the set above the triangle of three corners of the face at hand, whose plane is f->form. */
static graze_status add_above(faces *f, size_t second) {
    const int up = fmpq_sgn(f->form + 2);
    const size_t corner[3] = {f->corner[0], f->corner[second], f->corner[second + 1]};
    size_t part[4];
    csg_linear_form(f->r->f, f->r, f->form, f->r->coordinate, f->form + 3);
    TRY(csg_add_side(&part[3], f->r, up > 0));
    fmpq_zero(f->form + 2);
    for (int k = 0; k < 3; k++) {
        const fmpq *a = f->point + 3 * corner[k], *b = f->point + 3 * corner[(k + 1) % 3];
        fmpq_sub(f->form, b + 1, a + 1);
        fmpq_sub(f->form + 1, a, b);
        _fmpq_vec_dot(f->form + 3, f->form, a, 2);
        csg_linear_form(f->r->f, f->r, f->form, f->r->coordinate, f->form + 3);
        TRY(csg_add_side(&part[k], f->r, up < 0));
    }
    return csg_add_node(&f->node[f->nodes++], f->r, CSG_ALL, part, 4);
}

/* Replace the half-spaces by the sets above the triangles. */
static graze_status add_notched(faces *f, const json *list) {
    f->nodes = 0;
    for (const json *face = list->first; face; face = face->next) {
        TRY(read_corners(f, face));
        for (size_t k = 1; k + 1 < face->count; k++)
            if (set_plane(f, f->corner[0], f->corner[k], f->corner[k + 1]) &&
                !fmpq_is_zero(f->form + 2))
                TRY(add_above(f, k));
    }
    return GRAZE_OK;
}

static graze_status polyhedron_points(faces *f, const json *value) {
    HELD(csg_box, box);
    for (const json *item = value->first; item; item = item->next) {
        fmpq *x = f->point + 3 * item->index;
        TRY(csg_read_vector(x, f->r, item, 3));
        for (int i = 0; i < 3; i++)
            csg_box_hold(&box, i, x + i, x + i);
        box.dimension = 3;
    }
    csg_bound_corners(f->r, box.low, box.high);
    return GRAZE_OK;
}

static graze_status polyhedron_faces(size_t *node, faces *f, const json *points, const json *list) {
    size_t corners = 0, most = 0;
    for (const json *face = list->first; face; face = face->next) {
        corners += face->count;
        most = face->count > most ? face->count : most;
    }
    LOCAL_VEC(fmpq, point, (slong)(3 * points->count));
    LOCAL_VEC(fmpq, form, 10);
    FREED(size_t, corner, malloc((most + 1) * sizeof *corner));
    FREED(edge, sides, malloc((corners + 1) * sizeof *sides));
    FREED(size_t, planes, malloc((corners + 1) * sizeof *planes));
    if (!corner || !sides || !planes)
        return context_fail(f->r->context, GRAZE_ESYSTEM, "out of memory for a polyhedron");
    f->points = points->count;
    f->point = point;
    f->form = form;
    f->corner = corner;
    f->edge = sides;
    f->node = planes;
    TRY(polyhedron_points(f, points));
    for (const json *face = list->first; face; face = face->next)
        TRY(read_face(f, face));
    TRY(check_closed(f));
    if (f->notched)
        TRY(add_notched(f, list));
    return csg_add_node(node, f->r, f->notched ? CSG_ODD : CSG_ALL, f->node, f->nodes);
}

graze_status csg_read_polyhedron(size_t *node, csg_reader *r, const json *value) {
    static const char *const names[] = {"points", "faces"};
    const json *member[2];
    faces f = {.r = r, .value = value};
    TRY(csg_read_members(member, r, value, names, 2, 2));
    TRY(csg_in_space(r, value));
    for (int k = 0; k < 2; k++)
        TRY(json_array(r->context, member[k], 0));
    return polyhedron_faces(node, &f, member[0], member[1]);
}
