/* Finds rational zeros on lines: where the discriminant is a square.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/generate/charts.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

/* NUMBERS of a quadratic's array; REACH_PLANE and REACH_SPACE, the largest components of directions
 * in two and three variables; places beside the centre lie on an axis at up to BESIDE eighths (1 /
 * PARTS) on both sides. */
enum { NUMBERS = 16, REACH_PLANE = 8, REACH_SPACE = 4, BESIDE = 16, PARTS = 8 };

void quadratic_init(quadratic *q) {
    q->count = 0;
    q->start = _fmpq_vec_init(NUMBERS);
    q->slope = q->start + 3;
    q->value = q->start + 6;
    q->form = q->start + 7;
}

void quadratic_set(quadratic *to, const quadratic *from) {
    to->count = from->count;
    vector_set(to->start, from->start, NUMBERS);
}

void quadratic_clear(quadratic *q) {
    _fmpq_vec_clear(q->start, NUMBERS);
}

void quadratic_read(quadratic *q, const fmpq_mpoly_t p, int count, const fmpq_mpoly_ctx_t ring) {
    q->count = count;
    for (int i = 0; i < 3; i++)
        fmpq_zero(q->start + i);
    for (int i = -1; i < count; i++)
        for (int j = i < 0 ? -1 : i; j < count; j++) {
            ulong power[3] = {(i == 0) + (j == 0), (i == 1) + (j == 1), (i == 2) + (j == 2)};
            fmpq *to = j < 0 ? q->value : i < 0 ? q->slope + j : q->form + 3 * i + j;
            fmpq_mpoly_get_coeff_fmpq_ui(to, p, power, ring);
            if (i < 0 || i == j)
                continue;
            fmpq_div_2exp(to, to, 1);
            fmpq_set(q->form + 3 * j + i, to);
        }
}

/* out = form v */
static void apply_form(fmpq *out, const quadratic *q, const fmpq *v) {
    for (int i = 0; i < q->count; i++)
        _fmpq_vec_dot(out + i, q->form + 3 * i, v, q->count);
}

/* Move the start to start + v. */
static void move_start(quadratic *q, const fmpq *v) {
    LOCAL_VEC(fmpq, image, 4);
    apply_form(image, q, v);
    for (int i = 0; i < q->count; i++) {
        fmpq_add(image + 3, q->slope + i, image + i);
        fmpq_addmul(q->value, image + 3, v + i);
        fmpq_add(q->slope + i, image + 3, image + i);
        fmpq_add(q->start + i, q->start + i, v + i);
    }
}

/* The start moves by the v that solves slope + 2 form v = 0. */
int quadratic_center(quadratic *q) {
    LOCAL(fmpq_mat, form, q->count, q->count);
    LOCAL(fmpq_mat, slope, q->count, 1);
    LOCAL(fmpq_mat, v, q->count, 1);
    for (int i = 0; i < q->count; i++) {
        for (int j = 0; j < q->count; j++)
            fmpq_mul_2exp(fmpq_mat_entry(form, i, j), q->form + 3 * i + j, 1);
        fmpq_neg(fmpq_mat_entry(slope, i, 0), q->slope + i);
    }
    int found = fmpq_mat_can_solve(v, form, slope);
    if (found)
        move_start(q, fmpq_mat_entry(v, 0, 0));
    return found;
}

/* The coefficients of x^2 and of x of the polynomial at start + x v. */
static void restrict_to_line(fmpq *square, fmpq *first, const quadratic *q, const fmpq *v) {
    LOCAL_VEC(fmpq, image, 3);
    apply_form(image, q, v);
    _fmpq_vec_dot(square, image, v, q->count);
    _fmpq_vec_dot(first, q->slope, v, q->count);
}

/* Set x[2] to a rational root of a x^2 + b x + value, the polynomial at start + x v; returns 0
 * without one. x has room for 4 numbers. */
static int root_on_line(fmpq *x, const quadratic *q, const fmpq *v) {
    fmpq *a = x, *b = x + 1, *root = x + 2;
    restrict_to_line(a, b, q, v);
    if (fmpq_is_zero(a)) {
        if (fmpq_is_zero(b))
            return 0;
        fmpq_div(root, q->value, b);
        fmpq_neg(root, root);
        return 1;
    }
    fmpq_mul(root, a, q->value);
    fmpq_mul_2exp(root, root, 2);
    fmpq_mul(x + 3, b, b);
    fmpq_sub(root, x + 3, root);
    if (!fmpz_is_square(fmpq_numref(root)) || !fmpz_is_square(fmpq_denref(root)))
        return 0;
    fmpz_sqrt(fmpq_numref(root), fmpq_numref(root));
    fmpz_sqrt(fmpq_denref(root), fmpq_denref(root));
    fmpq_sub(root, root, b);
    fmpq_div(root, root, a);
    fmpq_div_2exp(root, root, 1);
    return 1;
}

/* Move the start to a zero on the line through the start along v, if a zero is found there whose
 * gradient is not zero. */
static int take_zero_along(quadratic *q, const fmpq *v) {
    LOCAL_VEC(fmpq, x, 7);
    fmpq *step = x + 4;
    int found = root_on_line(x, q, v);
    HELD(quadratic, moved);
    if (found) {
        for (int i = 0; i < q->count; i++)
            fmpq_mul(step + i, v + i, x + 2);
        quadratic_set(&moved, q);
        move_start(&moved, step);
        found = !vector_is_zero(moved.slope, q->count);
    }
    if (found)
        quadratic_set(q, &moved);
    return found;
}

/* Try the lines through the start along directions of small integers, of v and -v only one: that
 * whose last component that is not zero is positive.
 */
static int search_lines(quadratic *q, int reach) {
    LOCAL_VEC(fmpq, v, 3);
    int side = 2 * reach + 1, count = 1, found = 0;
    for (int i = 0; i < q->count; i++)
        count *= side;
    for (int k = count / 2 + 1; k < count && !found; k++) {
        for (int i = 0, rest = k; i < q->count; i++, rest /= side)
            fmpq_set_si(v + i, rest % side - reach, 1);
        found = take_zero_along(q, v);
    }
    return found;
}

/* Try lines parallel to an axis through places beside the start on another axis. */
static int search_beside(quadratic *q) {
    LOCAL_VEC(fmpq, v, 3);
    int found = 0;
    HELD(quadratic, moved);
    for (int k = 0; k < 2 * BESIDE * q->count && !found; k++) {
        int axis = k % q->count, part = 1 + k / q->count / 2;
        quadratic_set(&moved, q);
        fmpq_set_si(v + axis, k / q->count % 2 ? part : -part, PARTS);
        move_start(&moved, v);
        for (int i = 0; i < q->count; i++)
            fmpq_zero(v + i);
        for (int i = 0; i < q->count && !found; i++) {
            fmpq_one(v + i);
            found = i != axis && take_zero_along(&moved, v);
            fmpq_zero(v + i);
        }
    }
    if (found)
        quadratic_set(q, &moved);
    return found;
}

int quadratic_find_zero(quadratic *q) {
    (void)quadratic_center(q);
    return search_lines(q, q->count == 2 ? REACH_PLANE : REACH_SPACE) || search_beside(q);
}

/* Find the axis of a cylinder: the direction that the form maps to 0, and along which the slope is
 * 0. */
static int cylinder_axis(fmpq *out, const quadratic *q) {
    LOCAL_VEC(fmpq, image, 4);
    int found = 0;
    for (int k = 0; k < 3 && !found; k++) {
        vector_cross(out, q->form + 3 * k, q->form + 3 * ((k + 1) % 3));
        apply_form(image, q, out);
        _fmpq_vec_dot(image + 3, q->slope, out, 3);
        found = !vector_is_zero(out, 3) && vector_is_zero(image, 4);
    }
    return found;
}

int quadratic_ruling(fmpq *out, const quadratic *q, const fmpq *x) {
    if (q->count != 3 || cylinder_axis(out, q))
        return q->count == 3;
    HELD(quadratic, apex);
    quadratic_set(&apex, q);
    int found = quadratic_center(&apex) && fmpq_is_zero(apex.value);
    vector_sub(out, x, apex.start, 3);
    return found && !vector_is_zero(out, 3);
}

int quadratic_other_zero(fmpq *out, const quadratic *q, const fmpq *direction) {
    LOCAL_VEC(fmpq, x, 3);
    restrict_to_line(x, x + 1, q, direction);
    int found = !fmpq_is_zero(x) && !fmpq_is_zero(x + 1);
    if (found)
        fmpq_div(x + 2, x + 1, x);
    for (int i = 0; i < q->count && found; i++) {
        fmpq_set(out + i, q->start + i);
        fmpq_submul(out + i, x + 2, direction + i);
    }
    return found;
}
