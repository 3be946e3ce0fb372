/* Grids of cells: layout, exact classification, runs.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/views.h"

#include "base/context/scope.h"
#include "base/number/decimal.h"
#include "base/number/vector.h"
#include "decide/verdict/verdict.h"

tone tone_of(const graze_verdict *v) {
    if (v->pmc == GRAZE_PMC_UNDECIDED || v->class_ == GRAZE_CLASS_UNDECIDED)
        return TONE_NONE;
    return v->class_ == GRAZE_CLASS_NONE ? (tone)(TONE_IN - 1 + (int)v->pmc) : (tone)v->class_;
}

/* Choose the number of cells along one axis. Their excess over the box is half on each side. */
static graze_status lay_axis(cells *c, graze_context *context, int k, const fmpq *low,
                             const fmpq *high) {
    LOCAL(fmpq, length);
    LOCAL(fmpz, count);
    fmpq_sub(length, high + c->axis[k], low + c->axis[k]);
    LOCAL(fmpq, ratio);
    fmpq_div(ratio, length, c->side);
    fmpz_cdiv_q(count, fmpq_numref(ratio), fmpq_denref(ratio));
    unsigned long most = context->limits[GRAZE_LIMIT_GRID];
    if (fmpz_cmp_ui(count, most) > 0)
        return context_limit(context, GRAZE_LIMIT_GRID, "the cells of a picture");
    c->count[k] = fmpz_get_ui(count);
    /* low - (count side - length) / 2 */
    fmpq_mul_fmpz(ratio, c->side, count);
    fmpq_sub(ratio, length, ratio);
    fmpq_div_2exp(ratio, ratio, 1);
    fmpq_add(c->low + c->axis[k], low + c->axis[k], ratio);
    return GRAZE_OK;
}

graze_status cells_layout(cells *out, graze_context *context, int dimension, const int axis[2],
                          const fmpq *low, const fmpq *high, const fmpq_t plane,
                          unsigned long longer, int coarse) {
    memset(out, 0, sizeof *out);
    out->parts = 1;
    out->dimension = dimension;
    out->axis[0] = axis[0];
    out->axis[1] = axis[1];
    out->low = _fmpq_vec_init(dimension);
    fmpq_init(out->side);
    for (int k = 0; k < dimension; k++)
        if (k != axis[0] && k != axis[1])
            fmpq_set(out->low + k, plane);
    LOCAL(fmpq, other);
    fmpq_sub(out->side, high + axis[0], low + axis[0]);
    fmpq_sub(other, high + axis[1], low + axis[1]);
    int wide = fmpq_get_d(out->side) > CELLS_WIDE * fmpq_get_d(other);
    if (fmpq_cmp(other, out->side) > 0)
        fmpq_set(out->side, other);
    if (!longer)
        longer = (wide ? 360 : 240) / (coarse ? 2 : 1);
    LOCAL(fmpz, parts);
    fmpz_set_ui(parts, longer);
    fmpq_div_fmpz(out->side, out->side, parts);
    TRY(lay_axis(out, context, 0, low, high));
    TRY(lay_axis(out, context, 1, low, high));
    if (out->count[0] > context->limits[GRAZE_LIMIT_GRID] / out->count[1])
        return context_limit(context, GRAZE_LIMIT_GRID, "the cells of a picture");
    return MAKE_ARRAY(context, out->tone, out->count[0] * out->count[1], "the cells of a picture");
}

void cells_clear(cells *c) {
    if (!c->low)
        return;
    _fmpq_vec_clear(c->low, c->dimension);
    fmpq_clear(c->side);
    free(c->tone);
    free(c->split);
    free(c->part);
    free(c->distance);
    memset(c, 0, sizeof *c);
}

void cells_place(fmpq *out, const cells *c, size_t parts, size_t i, size_t j) {
    LOCAL_VEC(fmpq, uv, 2);
    LOCAL(fmpq, share);
    fmpq *at = c->section ? uv : out;
    vector_set(at, c->low, c->dimension);
    for (int k = 0; k < 2; k++) {
        fmpq_set_ui(share, k ? j : i, parts);
        fmpq_mul(share, share, c->side);
        fmpq_add(at + c->axis[k], at + c->axis[k], share);
    }
    if (c->section)
        section_point(out, c->section, uv);
}

graze_status cells_ask(tone *out, const cells *c, graze_context *context, const graze_scene *scene,
                       size_t parts, size_t i, size_t j) {
    LOCAL_VEC(fmpq, point, 3);
    graze_verdict verdict;
    cells_place(point, c, parts, i, j);
    graze_status status =
        classify_verdict(&verdict, context, scene, (query_point){.rational = point});
    *out = status ? TONE_NONE : tone_of(&verdict);
    return status;
}

graze_status cells_classify(cells *c, graze_context *context, const graze_scene *scene) {
    for (size_t j = 0; j < c->count[1]; j++) {
        TRY(context_poll(context));
        for (size_t i = 0; i < c->count[0]; i++) {
            tone found;
            TRY(cells_ask(&found, c, context, scene, 2, 2 * i + 1, 2 * j + 1));
            c->tone[j * c->count[0] + i] = (unsigned char)found;
        }
    }
    return GRAZE_OK;
}

void cells_plane(text *out, const cells *c, int axis) {
    enum { LONG = 13, SHORT_DIGITS = 6, DIGITS = 10 };
    int exact;
    if (c->section) {
        section_equation(out, c->section);
        return;
    }
    size_t start = out->length;
    text_format(out, "%c = ", "xyz"[axis]);
    text_rational(out, c->low + axis);
    int is_long = out->length - start > LONG + 4;
    if (!is_long && fmpz_is_one(fmpq_denref(c->low + axis)))
        return;
    char *near = decimal_of_rational(&exact, c->low + axis, is_long ? DIGITS : SHORT_DIGITS);
    if (is_long)
        out->length = start + 1;
    text_put(out, exact ? " = " : " ≈ ");
    text_owned(out, near);
}

extent cells_extent(const cells *c) {
    extent e;
    for (int k = 0; k < 2; k++) {
        e.low[k] = fmpq_get_d(c->low + c->axis[k]);
        e.high[k] = e.low[k] + fmpq_get_d(c->side) * (double)c->count[k];
    }
    return e;
}

void cells_corner(double out[3], const cells *c, double horizontal, double vertical) {
    for (int k = 0; k < 3; k++) {
        const section *s = c->section;
        out[k] = s ? fmpq_get_d(s->origin + k) + horizontal * s->look.row[0][k] +
                         vertical * s->look.row[1][k]
                 : k == c->axis[0]  ? horizontal
                 : k == c->axis[1]  ? vertical
                 : k < c->dimension ? fmpq_get_d(c->low + k)
                                    : 0;
    }
}

const char *cells_axes(const cells *c) {
    return c->section ? "uv" : "xyz";
}

void cells_attributes(text *out, const cells *c, const panel *p) {
    const char *names = cells_axes(c);
    text_format(out, "data-axes=\"%c %c\" data-count=\"%zu %zu\" data-parts=\"%zu\" data-low=\"",
                names[c->axis[0]], names[c->axis[1]], c->count[0], c->count[1], c->parts);
    for (int k = 0; k < c->dimension; k++) {
        text_put(out, k ? " " : "");
        text_rational(out, c->low + k);
    }
    text_put(out, "\"");
    if (c->section)
        section_describe(out, c->section, 1);
    text_put(out, " data-side=\"");
    text_rational(out, c->side);
    text_format(out, "\" data-frame=\"%ld %ld %ld %ld\"", (long)p->x, (long)p->y, (long)p->width,
                (long)p->height);
}
