/* Offsets whose edges keep their directions, and meet in corners.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Each edge is moved along its normal. The outline gains, or loses, the points between an edge and
 * the moved one; two moved edges that turn away from their corner are drawn out until they meet.
 */
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "input/csg/csg.h"
#include "input/scad/hull.h"

/* Roots of squares of size 2^80 are taken within 2^-24; 1 + cos of the angle between normals is at
 * least 2^-SHARP_BITS. */
enum { SIZE_BITS = 40, SHARP_BITS = 40 };

/* Set n to the unit normal of the edge from a to b on its right; `near` if it is rounded. */
static graze_status find_normal(fmpq *n, int *near, const scad_writer *w, const scad_place *p,
                                const fmpq *a, const fmpq *b) {
    LOCAL_VEC(fmpq, v, 4);
    fmpq *size = v + 2, *root = v + 3;
    vector_sub(v, b, a, 2);
    scad_hold(size, v, 2);
    fmpq_div_2exp(size, size, SIZE_BITS);
    fmpq_div(n, v + 1, size);
    fmpq_div(n + 1, v, size);
    fmpq_neg(n + 1, n + 1);
    _fmpq_vec_dot(v, n, n, 2);
    csg_upper_root(root, v);
    for (int i = 0; i < 2; i++)
        fmpq_div(n + i, n + i, root);
    fmpq_mul(root, root, root);
    *near = !fmpq_equal(root, v);
    if (*near && !w->choice->near_rotation)
        return scad_fail(p, GRAZE_EINPUT,
                         "an edge's length is irrational; expected r in place of delta, or "
                         "near_rotation: graze convert --near-rotation takes it");
    return GRAZE_OK;
}

/* Set x to where the edges at a corner meet when they are moved by 1 along their normals n and
 * n + 2, and `moved` to the square of the factor by which errors of normals grow. */
static graze_status find_mitre(fmpq *x, fmpq_t moved, const scad_place *p, const fmpq *n) {
    LOCAL_VEC(fmpq, v, 2);
    fmpq *least = v + 1;
    _fmpq_vec_dot(v, n, n + 2, 2);
    fmpq_add_si(v, v, 1);
    fmpq_one(least);
    fmpq_div_2exp(least, least, SHARP_BITS);
    if (fmpq_cmp(v, least) < 0)
        return scad_fail(p, GRAZE_EINPUT, "a corner is too sharp for delta; expected r");
    vector_add(x, n, n + 2, 2);
    for (int i = 0; i < 2; i++)
        fmpq_div(x + i, x + i, v);
    fmpq_inv(moved, v);
    fmpq_mul(moved, moved, moved);
    return GRAZE_OK;
}

graze_status scad_moved_edge(scad_shape *piece, scad_writer *w, const scad_place *p,
                             const fmpq_t by, const fmpq *const *corner) {
    LOCAL_VEC(fmpq, n, 11);
    fmpq *x = n + 6, *moved = n + 9, *turn = n + 10;
    int near[3];
    for (int k = 0; k < 3; k++)
        TRY(find_normal(n + 2 * k, &near[k], w, p, corner[k], corner[k + 1]));
    w->turned += (size_t)near[1];
    for (int k = 1; k < 3; k++)
        TRY(hull_add_point(&piece->points, w->context, corner[k], "the points of a polygon"));
    for (int k = 1; k >= 0; k--) {
        fmpq *before = n + 2 * k;
        fmpq_one(moved);
        vector_set(x, n + 2, 2);
        cross_rationals(turn, corner[k], corner[k + 1], corner[k + 2], 0, 1);
        if (fmpq_sgn(turn) * fmpq_sgn(by) > 0)
            TRY(find_mitre(x, moved, p, before));
        for (int i = 0; i < 2; i++) {
            fmpq_mul(x + i, x + i, by);
            fmpq_add(x + i, x + i, corner[k + 1] + i);
        }
        TRY(hull_add_point(&piece->points, w->context, x, "the points of a polygon"));
        scad_hold(w->reach, x, 2);
        fmpq_mul(moved, moved, by);
        fmpq_div_2exp(moved, moved, 57);
        if (near[0] || near[1] || near[2])
            scad_hold(w->moved, moved, 1);
    }
    return numbers_add(&piece->end, w->context, 4, "the rings of a polygon");
}
