/* Points of a facet with g = theta = 0 and a third derivative of 0.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The three functions are linear on the facet's plane. By their values at the corners of one
 * triangle, barycentric coordinates of a common zero are the kernel of a 3 x 3 matrix of
 * polynomials (proofs/events.md C80). Its determinant vanishes where there is one; where it
 * vanishes all the time, the minors and values tell where the zero changes.
 */
#include "envelope/singular.h"

#include <stdlib.h>
#include "envelope/judge.h"
#include "number/sign.h"

/* The functions at the corners, the products of two rows, and the determinant. */
enum { ROWS = 9, MINORS = 9, DETERMINANT = ROWS + MINORS, SINGULAR_SIGNS };

typedef struct singular_view {
    graze_envelope *e;
    graze_context *context;
    size_t facet, piece;
    const size_t *corner; /* of the first triangle */
    fmpz_poly_struct p[SINGULAR_SIGNS];
} singular_view;

static void derivative_at(fmpz_poly_struct *out, const singular_view *v, int row, size_t vertex) {
    field_along(out, &v->e->field[v->piece], row + 1, v->facet, vertex);
}

/* The minors of rows a and b: their cross product. */
static void set_minors(fmpz_poly_struct *out, const fmpz_poly_struct *a,
                       const fmpz_poly_struct *b) {
    fmpz_poly_t second;
    fmpz_poly_init(second);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        fmpz_poly_mul(out + i, a + j, b + k);
        fmpz_poly_mul(second, a + k, b + j);
        fmpz_poly_sub(out + i, out + i, second);
    }
    fmpz_poly_clear(second);
}

static void fill_view(singular_view *v) {
    fmpz_poly_struct *p = v->p, *minor = v->p + ROWS;
    fmpz_poly_t term;
    fmpz_poly_init(term);
    for (int row = 0; row < 3; row++)
        for (int k = 0; k < 3; k++)
            derivative_at(p + row * 3 + k, v, row, v->corner[k]);
    set_minors(minor, p, p + 3);
    set_minors(minor + 3, p, p + 6);
    set_minors(minor + 6, p + 3, p + 6);
    for (int k = 0; k < 3; k++) {
        fmpz_poly_mul(term, minor + k, p + 6 + k);
        fmpz_poly_add(p + DETERMINANT, p + DETERMINANT, term);
    }
    fmpz_poly_clear(term);
}

/* Is a homogeneous point, polynomials at u, within the facet's relative interior or on a side that
 * two of its triangles share? *out: 1 if a triangle holds it in its interior or on such a side. */
static graze_status is_point_in_triangle(int *out, const singular_view *v, algebraic *u,
                                         size_t simplex, const fmpz_poly_struct *point) {
    const cell_complex *c = &v->e->cells;
    graze_status status = GRAZE_OK;
    unsigned zeros = 0;
    fmpz form[8] = {0};
    fmpz_poly_t value;
    fmpz_poly_init(value);
    solid_plane(form, c->solid, simplex);
    *out = 1;
    for (int k = 0; k < 3 && !status && *out; k++) {
        int sign = 0;
        solid_side(form + 4, c->solid, simplex, form, k);
        fmpz_poly_zero(value);
        for (int i = 0; i < 4; i++)
            fmpz_poly_scalar_addmul_fmpz(value, point + i, form + 4 + i);
        status = algebraic_sign_at(&sign, v->context, value, u);
        *out = sign >= 0;
        zeros += sign == 0 ? 1 : 0;
        if (sign == 0) {
            size_t a = c->corner[simplex * 3 + (size_t)k];
            size_t b = c->corner[simplex * 3 + (size_t)(k + 1) % 3];
            int shared = 0;
            for (size_t j = 0; j < c->facet[v->facet].count; j++) {
                const size_t *q = c->corner + c->order[c->facet[v->facet].first + j] * 3;
                shared +=
                    (q[0] == a || q[1] == a || q[2] == a) && (q[0] == b || q[1] == b || q[2] == b);
            }
            *out &= shared == 2;
        }
    }
    *out &= zeros < 2;
    for (int i = 0; i < 8; i++)
        fmpz_clear(form + i);
    fmpz_poly_clear(value);
    return status;
}

/* Is the point of these barycentric coordinates at u in the facet? */
static graze_status is_in_facet(int *out, const singular_view *v, algebraic *u,
                                const fmpz_poly_struct *weight) {
    const cell_complex *c = &v->e->cells;
    const cell_facet *f = &c->facet[v->facet];
    fmpz_poly_struct point[4];
    int side = 0;
    for (int i = 0; i < 4; i++) {
        fmpz_poly_init(point + i);
        for (int k = 0; k < 3; k++)
            fmpz_poly_scalar_addmul_fmpz(point + i, weight + k, c->vertex[v->corner[k]].x + i);
    }
    *out = 0;
    graze_status status = algebraic_sign_at(&side, v->context, point + 3, u);
    for (int i = 0; i < 4 && side < 0; i++)
        fmpz_poly_neg(point + i, point + i);
    for (size_t j = 0; j < f->count && side != 0 && !status && !*out; j++)
        status = is_point_in_triangle(out, v, u, c->order[f->first + j], point);
    for (int i = 0; i < 4; i++)
        fmpz_poly_clear(point + i);
    return status;
}

/* Do the three values not all vanish at u? */
static graze_status is_nonzero(int *out, const singular_view *v, algebraic *u,
                               const fmpz_poly_struct *p) {
    graze_status status = GRAZE_OK;
    *out = 0;
    for (int k = 0; k < 3 && !status && !*out; k++)
        status = algebraic_sign_at(out, v->context, p + k, u);
    *out = *out != 0;
    return status;
}

/* Has a function of the facet both signs at its corners, at u? */
static graze_status changes_sign(int *out, const singular_view *v, algebraic *u, int row) {
    const cell_complex *c = &v->e->cells;
    const cell_facet *f = &c->facet[v->facet];
    graze_status status = GRAZE_OK;
    int positive = 0, negative = 0;
    fmpz_poly_t value;
    fmpz_poly_init(value);
    for (size_t j = 0; j < 3 * f->count && !status; j++) {
        int sign = 0;
        derivative_at(value, v, row, c->corner[c->order[f->first + j / 3] * 3 + j % 3]);
        status = algebraic_sign_at(&sign, v->context, value, u);
        positive |= sign > 0;
        negative |= sign < 0;
    }
    fmpz_poly_clear(value);
    *out = positive && negative;
    return status;
}

/* Is there such a point in the facet at u? */
static graze_status exists_at(int *out, const singular_view *v, algebraic *u) {
    int sign = 0, some = 0;
    *out = 0;
    graze_status status = algebraic_sign_at(&sign, v->context, v->p + DETERMINANT, u);
    if (status || sign != 0)
        return status;
    for (int pair = 0; pair < 3 && !status; pair++) {
        status = is_nonzero(&some, v, u, v->p + ROWS + 3 * pair);
        if (!status && some)
            return is_in_facet(out, v, u, v->p + ROWS + 3 * pair);
    }
    for (int row = 0; row < 3 && !status; row++) {
        status = is_nonzero(&some, v, u, v->p + 3 * row);
        if (!status && some)
            return changes_sign(out, v, u, row);
    }
    *out = !status;
    return status;
}

static graze_status exists_before(int *out, const singular_view *v, const axis *x, size_t k) {
    algebraic u;
    algebraic_init(&u);
    algebraic_set_rational(&u, x->sample + k);
    graze_status status = exists_at(out, v, &u);
    algebraic_clear(&u);
    return status;
}

/* A point is an event if it has what one of the places beside it has not, or the reverse. */
static graze_status watch_points(const singular_view *v, axis *x, int always) {
    graze_envelope *e = v->e;
    const graze_cell *name = &e->cells.facet[v->facet].name;
    found_event what = {.kind = GRAZE_EVENT_SINGULAR,
                        .facet = *name,
                        .cell = *name,
                        .before = SIGN_NONE,
                        .after = SIGN_NONE};
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < x->count && !status; k++) {
        int here = 0, before = 0, after = 0;
        int is_joint = k + 1 == x->count && v->piece + 1 < e->piece_count;
        if (is_joint || judge_is_break(e, v->piece, x, k))
            continue;
        status = exists_at(&here, v, x->point[k]);
        before = after = here;
        if (!status && k > 0)
            status = always ? exists_before(&before, v, x, k) : GRAZE_OK;
        if (!status && k + 1 < x->count)
            status = always ? exists_before(&after, v, x, k + 1) : GRAZE_OK;
        if (!status && ((here && !always) || before != here || after != here))
            status = events_add(&e->events, v->context, &what, v->piece, x->point[k]);
    }
    return status;
}

/* Has g one strict sign at all corners of the facet, all the time? */
static int is_never_in_contact(const singular_view *v) {
    const cell_complex *c = &v->e->cells;
    const cell_facet *f = &c->facet[v->facet];
    int sign = 0, same = 1;
    fmpz_poly_t g;
    fmpz_poly_init(g);
    for (size_t j = 0; j < 3 * f->count && same; j++) {
        derivative_at(g, v, 0, c->corner[c->order[f->first + j / 3] * 3 + j % 3]);
        int here = axis_one_sign(g);
        same = here != 0 && (j == 0 || here == sign);
        sign = here;
    }
    fmpz_poly_clear(g);
    return same;
}

graze_status singular_gather(graze_envelope *e, graze_context *context, size_t facet) {
    const cell_complex *c = &e->cells;
    graze_status status = GRAZE_OK;
    for (size_t piece = 0; piece < e->piece_count && !status; piece++) {
        singular_view v = {
            e, context, facet, piece, c->corner + c->order[c->facet[facet].first] * 3, {{0}}};
        if (e->still[piece * c->facet_count + facet] || is_never_in_contact(&v))
            continue;
        for (int k = 0; k < SINGULAR_SIGNS; k++)
            fmpz_poly_init(v.p + k);
        fill_view(&v);
        int always = fmpz_poly_is_zero(v.p + DETERMINANT);
        axis x;
        status =
            axis_make(&x, context, always ? v.p : v.p + DETERMINANT, always ? SINGULAR_SIGNS : 1);
        if (!status)
            status = watch_points(&v, &x, always);
        axis_clear(&x);
        for (int k = 0; k < SINGULAR_SIGNS; k++)
            fmpz_poly_clear(v.p + k);
    }
    return status;
}
