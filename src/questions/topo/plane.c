/* Coordinates of planes, lists of curves in them, and shifts of curves, one variable after the
 * other; the caller can cancel between two rows.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * With P = (a / c, b / c) and D the degree, c^D g(P + (x, y)) is the sum of g_ij c^(D - i - j)
 * (X + a)^i (Y + b)^j with X = c x, Y = c y.
 */
#include "base/context/array.h"
#include "base/context/scope.h"
#include "questions/topo/eliminate.h"

void plane_view_init(plane_view *view) {
    *view = (plane_view){2, {{0, 1}, {0, 1}, {0, 1}}, {{1, 0, 0}, {0, 1, 0}}};
}

void view_set_through(plane_view *view, const fmpq *point, const fmpz *a, const fmpz *b) {
    view->dimension = 3;
    for (int i = 0; i < 3; i++)
        fmpq_set(view->origin + i, point + i);
    _fmpz_vec_set(view->along[0], a, 3);
    _fmpz_vec_set(view->along[1], b, 3);
}

void plane_view_clear(plane_view *view) {
    for (int i = 0; i < 3; i++)
        fmpq_clear(view->origin + i);
    for (int k = 0; k < 2; k++)
        _fmpz_vec_zero(view->along[k], 3);
}

void view_point(fmpq *out, const plane_view *view, const fmpq *xy) {
    LOCAL(fmpq, way);
    for (int i = 0; i < view->dimension; i++) {
        fmpq_set(out + i, view->origin + i);
        for (int k = 0; k < 2; k++) {
            fmpq_mul_fmpz(way, xy + k, view->along[k] + i);
            fmpq_add(out + i, out + i, way);
        }
    }
}

void curve_list_init(curve_list *list) {
    memset(list, 0, sizeof *list);
    fmpz_mpoly_ctx_init(list->ring, RING_VARIABLES, ORD_LEX);
}

void curve_list_clear(curve_list *list) {
    for (size_t k = 0; k < list->count; k++)
        fmpz_mpoly_clear(&list->item[k], list->ring);
    free(list->item);
    fmpz_mpoly_ctx_clear(list->ring);
}

graze_status curves_append(curve_list *list, graze_context *context, const fmpz_mpoly_t curve) {
    if (fmpz_mpoly_is_fmpz(curve, list->ring))
        return GRAZE_OK;
    TRY(LIST_GROW(context, list, "the curves of a sweep"));
    fmpz_mpoly_init(&list->item[list->count], list->ring);
    fmpz_mpoly_set(&list->item[list->count++], curve, list->ring);
    return GRAZE_OK;
}

/* Multiply each g_ij by c^(D - i - j) or, with `back`, by c^(i + j). */
static void scale_terms(sliced_curve *s, const fmpz_t c, int back) {
    LOCAL(fmpz, power);
    for (slong j = 0; j <= s->degree; j++)
        for (slong i = 0; i < fmpz_poly_length(s->coefficient + j); i++) {
            fmpz_pow_ui(power, c, (ulong)(back ? i + j : s->total - i - j));
            fmpz_mul(fmpz_poly_get_coeff_ptr(s->coefficient + j, i),
                     fmpz_poly_get_coeff_ptr(s->coefficient + j, i), power);
        }
}

/* Replace X by X + a in each coefficient. */
static graze_status shift_coefficients(sliced_curve *s, graze_context *context, const fmpz_t a) {
    for (slong k = 0; k <= s->degree; k++) {
        fmpz_poly_taylor_shift(s->coefficient + k, s->coefficient + k, a);
        TRY(context_poll(context));
    }
    return GRAZE_OK;
}

/* Convert to a polynomial, divided by its content. */
static void to_polynomial(fmpz_mpoly_t out, const sliced_curve *s, int variable,
                          const fmpz_mpoly_ctx_t ring) {
    LOCAL_VEC(fmpz, content, 2);
    fmpz *c = content + 1;
    for (slong k = 0; k <= s->degree; k++) {
        fmpz_poly_content(c, s->coefficient + k);
        fmpz_gcd(content, content, c);
    }
    fmpz_mpoly_zero(out, ring);
    for (slong k = 0; k <= s->degree; k++)
        for (slong i = 0; i < fmpz_poly_length(s->coefficient + k); i++) {
            ulong e[RING_VARIABLES];
            e[variable] = (ulong)k;
            e[1 - variable] = (ulong)i;
            fmpz_divexact(c, fmpz_poly_get_coeff_ptr(s->coefficient + k, i), content);
            if (!fmpz_is_zero(c))
                fmpz_mpoly_push_term_fmpz_ui(out, c, e, ring);
        }
    fmpz_mpoly_sort_terms(out, ring);
}

graze_status shift_curve(fmpz_mpoly_t out, graze_context *context, const fmpz_mpoly_t curve,
                         const fmpq *point, const fmpz_mpoly_ctx_t ring) {
    LOCAL_VEC(fmpz, place, 3); /* a, b, c */
    _fmpq_vec_get_fmpz_vec_fmpz(place, place + 2, point, 2);
    HELD(sliced_curve, rows, curve, RING_Y, ring);
    scale_terms(&rows, place + 2, 0);
    TRY(shift_coefficients(&rows, context, place));
    to_polynomial(out, &rows, RING_Y, ring);
    HELD(sliced_curve, columns, out, RING_X, ring);
    TRY(shift_coefficients(&columns, context, place + 1));
    scale_terms(&columns, place + 2, 1);
    to_polynomial(out, &columns, RING_X, ring);
    return GRAZE_OK;
}
