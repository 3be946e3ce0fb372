/* Merges roots in order, finds samples between them, and makes tables of signs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/scope.h"
#include "base/number/isolate.h"
#include "questions/envelope/sign_events.h"

/* Sort the roots into `point`; equal numbers stand there once. */
static graze_status order_points(axis *x, graze_context *context) {
    size_t n = x->roots.count;
    TRY(MAKE_ARRAY(context, x->point, n, "roots"));
    for (size_t k = 0; k < n; k++)
        x->point[k] = &x->roots.item[k];
    x->count = n;
    return algebraic_sort_once(x->point, &x->count, context, NULL, NULL);
}

graze_status axis_make(axis *out, graze_context *context, const fmpz_poly_struct *p, size_t count) {
    memset(out, 0, sizeof *out);
    algebraic_list_init(&out->roots);
    algebraic_list_append(&out->roots); /* 0 */
    fmpq_one(algebraic_list_append(&out->roots)->value);
    for (size_t k = 0; k < count; k++)
        if (!fmpz_poly_is_zero(p + k))
            TRY(algebraic_roots(&out->roots, context, p + k, &unit_interval));
    TRY(order_points(out, context));
    out->sample = _fmpq_vec_init((slong)out->count);
    for (size_t k = 1; k < out->count; k++)
        TRY(algebraic_between(out->sample + k, context, out->point[k - 1], out->point[k]));
    return GRAZE_OK;
}

void axis_clear(axis *x) {
    if (x->sample)
        _fmpq_vec_clear(x->sample, (slong)x->count);
    free(x->point);
    algebraic_list_clear(&x->roots);
}

int axis_sign_before(const axis *x, const fmpz_poly_struct *p, size_t k) {
    return fmpz_poly_is_zero(p) ? 0 : rational_sign(p, x->sample + k);
}

int axis_one_sign(const fmpz_poly_struct *p) {
    if (fmpz_poly_is_zero(p))
        return 0;
    HELD(bernstein_form, form, p, fmpz_poly_degree(p), &unit_interval);
    int low = wide_sign(&form.c, 0), high = wide_sign(&form.c, form.c.count - 1);
    return low == high && bernstein_variations(&form) == 0 ? low : 0;
}

void signs_init(signs *s, size_t count, size_t rooted) {
    memset(s, 0, sizeof *s);
    s->count = count;
    s->rooted = rooted;
    s->p = flint_malloc((count + 1) * sizeof *s->p);
    for (size_t p = 0; p < count; p++)
        fmpz_poly_init(&s->p[p]);
}

void signs_clear(signs *s) {
    for (size_t p = 0; p < s->count; p++)
        fmpz_poly_clear(&s->p[p]);
    flint_free(s->p);
    axis_clear(&s->x);
    free(s->at);
    free(s->before);
}

graze_status signs_find(signs *s, graze_context *context) {
    TRY(axis_make(&s->x, context, s->p, s->rooted));
    TRY(MAKE_ARRAY(context, s->at, s->x.count * s->count, "signs"));
    TRY(MAKE_ARRAY(context, s->before, s->x.count * s->count, "signs"));
    for (size_t k = 0; k < s->x.count; k++)
        for (size_t p = 0; p < s->count; p++) {
            int sign = 0;
            TRY(algebraic_sign_at(&sign, context, &s->p[p], s->x.point[k]));
            s->at[k * s->count + p] = (signed char)sign;
            if (k > 0)
                s->before[k * s->count + p] = (signed char)axis_sign_before(&s->x, &s->p[p], k);
        }
    return GRAZE_OK;
}

const signed char *signs_at(const signs *s, size_t k) {
    return s->at + k * s->count;
}

const signed char *signs_before(const signs *s, size_t k) {
    return s->before + k * s->count;
}
