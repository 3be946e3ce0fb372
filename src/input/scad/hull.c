/* Convex hulls of points, exactly: by sorting in the plane, point after point in space.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/scad/hull.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

/* Work of a point beside a face. */
enum { SIDE_WORK = 32 };

void hull_points_clear(hull_points *p) {
    for (size_t k = 0; k < 3 * p->count; k++)
        fmpq_clear(p->at + k);
    free(p->at);
    *p = (hull_points){.count = 0};
}

void hull_points_swap(hull_points *a, hull_points *b) {
    hull_points held = *a;
    *a = *b;
    *b = held;
}

void hull_faces_clear(hull_faces *f) {
    free(f->item);
}

graze_status hull_add_point(hull_points *p, graze_context *context, const fmpq *x,
                            const char *what) {
    TRY(array_grow(context, &p->at, &p->capacity, 3 * p->count + 3, sizeof *p->at, what));
    for (int i = 0; i < 3; i++)
        fmpq_init(p->at + 3 * p->count + i);
    vector_set(p->at + 3 * p->count++, x, 3);
    return GRAZE_OK;
}

static int hull_point_order(const void *left, const void *right) {
    return vector_compare(left, right, 3);
}

/* Keep the points with these numbers, in their order. */
static graze_status keep_points(hull_points *p, graze_context *context, const size_t *number,
                                size_t count) {
    ZEROED(hull_points, kept);
    for (size_t k = 0; k < count; k++)
        TRY(hull_add_point(&kept, context, p->at + 3 * number[k], "the points of a hull"));
    hull_points_swap(p, &kept);
    return GRAZE_OK;
}

graze_status hull_of_plane(hull_points *p, graze_context *context) {
    FREED(size_t, chain, malloc((2 * p->count + 2) * sizeof *chain));
    LOCAL(fmpq, turn);
    size_t count = 0;
    if (!chain)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for %zu points", p->count);
    qsort(p->at, p->count, 3 * sizeof *p->at, hull_point_order);
    for (size_t pass = 0, floor = 0; pass < 2 && p->count > 0; pass++, floor = count)
        for (size_t k = 0; k < p->count; k++) {
            size_t next = pass ? p->count - 1 - k : k;
            for (; count >= floor + 2; count--) {
                cross_rationals(turn, p->at + 3 * chain[count - 2], p->at + 3 * chain[count - 1],
                                p->at + 3 * next, 0, 1);
                if (fmpq_sgn(turn) > 0)
                    break;
            }
            if (k + 1 < p->count || (!pass && p->count == 1))
                chain[count++] = next;
        }
    return keep_points(p, context, chain, count);
}

int hull_side(const hull_points *p, const size_t *corner, size_t point) {
    LOCAL_VEC(fmpq, v, 12);
    const fmpq *from = p->at + 3 * corner[0];
    vector_sub(v, p->at + 3 * corner[1], from, 3);
    vector_sub(v + 3, p->at + 3 * corner[2], from, 3);
    vector_sub(v + 6, p->at + 3 * point, from, 3);
    vector_cross(v + 9, v, v + 3);
    _fmpq_vec_dot(v, v + 9, v + 6, 3);
    return fmpq_sgn(v);
}

static graze_status add_hull_face(hull_faces *f, graze_context *context, size_t a, size_t b,
                                  size_t c) {
    TRY(LIST_GROW(context, f, "the faces of a hull"));
    f->item[f->count++] = (hull_face){{a, b, c}};
    return GRAZE_OK;
}

/* Begin with a tetrahedron; its corners become points 0 to 3. None is made of points on a line. */
static graze_status begin_hull(hull_faces *f, hull_points *p, graze_context *context) {
    size_t corner[4] = {0, 1, 2, 2};
    while (corner[2] < p->count && vector_collinear(p->at, p->at + 3, p->at + 3 * corner[2]))
        corner[2]++;
    while (corner[3] < p->count && corner[2] < p->count && hull_side(p, corner, corner[3]) == 0)
        corner[3]++;
    if (corner[2] >= p->count)
        return GRAZE_OK;
    if (corner[3] >= p->count)
        return context_fail(context, GRAZE_EINPUT,
                            "the centres of a hull's balls are in one plane; expected them on a "
                            "line, or one outside of the plane");
    int before = hull_side(p, corner, corner[3]) > 0;
    const size_t a = corner[before], b = corner[!before], c = corner[2], d = corner[3];
    TRY(add_hull_face(f, context, a, b, c));
    TRY(add_hull_face(f, context, b, a, d));
    TRY(add_hull_face(f, context, c, b, d));
    return add_hull_face(f, context, a, c, d);
}

/* Replace the faces that see a point by those between it and their horizon. */
static graze_status insert_point(hull_faces *f, const hull_points *p, graze_context *context,
                                 size_t point) {
    size_t seen = 0;
    for (size_t k = 0; k < f->count; k++)
        if (hull_side(p, f->item[k].corner, point) > 0) {
            hull_face held = f->item[seen];
            f->item[seen++] = f->item[k];
            f->item[k] = held;
        }
    FREED(hull_face, gone, malloc((seen + 1) * sizeof *gone));
    if (!gone)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a hull");
    for (size_t k = 0; k < seen; k++)
        gone[k] = f->item[k];
    for (size_t k = 0; k < seen; k++)
        f->item[k] = f->item[--f->count];
    for (size_t k = 0; k < 3 * seen; k++) {
        size_t a = gone[k / 3].corner[k % 3], b = gone[k / 3].corner[(k + 1) % 3];
        int inner = 0;
        for (size_t i = 0; i < 3 * seen && !inner; i++)
            inner = gone[i / 3].corner[i % 3] == b && gone[i / 3].corner[(i + 1) % 3] == a;
        if (!inner)
            TRY(add_hull_face(f, context, a, b, point));
    }
    return context_work(context, SIDE_WORK * f->count);
}

/* Keep the corners of faces alone. */
static graze_status keep_corners(hull_faces *f, hull_points *p, graze_context *context) {
    ZEROED(numbers, used);
    for (size_t k = 0; k < 3 * f->count; k++)
        TRY(numbers_add(&used, context, f->item[k / 3].corner[k % 3], "the points of a hull"));
    numbers_sort(&used);
    for (size_t k = 0; k < 3 * f->count; k++) {
        size_t *corner = &f->item[k / 3].corner[k % 3];
        *corner =
            array_first(corner, used.item, used.count, sizeof *used.item, array_compare_numbers);
    }
    return keep_points(p, context, used.item, used.count);
}

graze_status hull_of_space(hull_faces *faces, hull_points *p, graze_context *context) {
    unsigned long work = 0, limit = context->limits[GRAZE_LIMIT_WORK];
    ZEROED(numbers, once);
    qsort(p->at, p->count, 3 * sizeof *p->at, hull_point_order);
    for (size_t k = 0; k < p->count; k++)
        if (k == 0 || vector_compare(p->at + 3 * (k - 1), p->at + 3 * k, 3) != 0)
            TRY(numbers_add(&once, context, k, "the points of a hull"));
    TRY(keep_points(p, context, once.item, once.count));
    TRY(begin_hull(faces, p, context));
    if (faces->count == 0)
        return keep_points(p, context, (size_t[]){0, p->count - 1}, p->count > 1 ? 2 : 1);
    for (size_t k = 0; k < p->count; k++) {
        TRY(insert_point(faces, p, context, k));
        work += SIDE_WORK * faces->count;
        if (work > limit)
            return context_limit(context, GRAZE_LIMIT_WORK, "the faces of a hull");
    }
    return keep_corners(faces, p, context);
}
