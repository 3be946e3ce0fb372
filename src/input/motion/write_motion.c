/* Writes a motion as plain pieces: every entry is a quotient of polynomials in the motion's own
 * parameter.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/motion/motion.h"

#include "base/context/scope.h"

/* out = p at u = (t - lo) / (hi - lo). */
static void in_time(fmpq_poly_t out, const fmpz_poly_t p, const motion_piece *piece) {
    LOCAL_VEC(fmpq, slope, 2);
    fmpq *shift = slope + 1;
    LOCAL(fmpq_poly, u);
    fmpq_sub(slope, piece->hi, piece->lo);
    fmpq_inv(slope, slope);
    fmpq_mul(shift, slope, piece->lo);
    fmpq_neg(shift, shift);
    fmpq_poly_set_coeff_fmpq(u, 0, shift);
    fmpq_poly_set_coeff_fmpq(u, 1, slope);
    fmpq_poly_set_fmpz_poly(out, p);
    fmpq_poly_compose(out, out, u);
}

/* Write a polynomial such as c_0 + c_1*t - c_2*t^2, without terms that are zero. */
static void write_poly(text *out, const fmpq_poly_t p) {
    LOCAL(fmpq, c);
    int first = 1;
    for (slong k = 0; k < fmpq_poly_length(p); k++) {
        fmpq_poly_get_coeff_fmpq(c, p, k);
        if (fmpq_is_zero(c))
            continue;
        if (!first)
            text_put(out, fmpq_sgn(c) < 0 ? " - " : " + ");
        if (!first)
            fmpq_abs(c, c);
        text_rational(out, c);
        if (k > 0)
            text_put(out, "*t");
        if (k > 1)
            text_format(out, "^%ld", (long)k);
        first = 0;
    }
    if (first)
        text_put(out, "0");
}

/* Write entry / weight. Both polynomials are multiplied by `scale` unless the weight is constant.
 */
static void write_entry(text *out, const fmpz_poly_t entry, const fmpq_poly_t weight,
                        const fmpz_t scale, const motion_piece *piece) {
    int whole = fmpq_poly_length(weight) == 1;
    LOCAL(fmpq_poly, p);
    in_time(p, entry, piece);
    if (whole)
        fmpq_poly_div(p, p, weight);
    else
        fmpq_poly_scalar_mul_fmpz(p, p, scale);
    text_put(out, whole ? "\"" : "\"(");
    write_poly(out, p);
    if (!whole) {
        text_put(out, ")/(");
        fmpq_poly_scalar_mul_fmpz(p, weight, scale);
        write_poly(out, p);
    }
    text_put(out, whole ? "\"" : ")\"");
}

/* The least common denominator of the coefficients of entries and weight. */
static void find_scale(fmpz_t out, const motion_piece *piece) {
    const point_map *m = &piece->forward;
    LOCAL(fmpq_poly, p);
    in_time(p, m->weight, piece);
    fmpz_set(out, fmpq_poly_denref(p));
    for (int k = 0; k < m->dimension * (m->dimension + 1); k++) {
        in_time(p, m->entry + k, piece);
        fmpz_lcm(out, out, fmpq_poly_denref(p));
    }
}

json_writer motion_begin(text *out, int dimension, const char *list, int apart) {
    json_writer w = {.out = out, .spaced = 1};
    json_open(&w, NULL, '{');
    json_count(&w, "dimension", (unsigned long)dimension);
    if (apart)
        json_line(&w, 0);
    json_open(&w, list, '[');
    return w;
}

void motion_begin_piece(json_writer *w, int indent, const fmpq_t from, const fmpq_t to,
                        unsigned long row, const char *kind, char bracket) {
    json_line(w, indent);
    json_open(w, NULL, '{');
    json_form(json_begin(w, "t"), "[%, %]", from, to);
    if (row)
        json_count(w, "row", row);
    json_open(w, "transform", '{');
    json_open(w, kind, bracket);
}

void motion_end(json_writer *w) {
    json_line(w, 0);
    json_ends(w, "]}");
    text_put(w->out, "\n");
}

void motion_put_piece(json_writer *w, const motion_piece *piece) {
    const point_map *m = &piece->forward;
    int d = m->dimension;
    LOCAL(fmpq_poly, weight);
    LOCAL(fmpz, scale);
    in_time(weight, m->weight, piece);
    find_scale(scale, piece);
    motion_begin_piece(w, 2, piece->lo, piece->hi, piece->row, "matrix", '[');
    for (int i = 0; i < d; i++) {
        json_line(w, 4);
        json_open(w, NULL, '[');
        for (int k = 0; k <= d; k++)
            write_entry(json_begin(w, NULL), m->entry + i * (d + 1) + k, weight, scale, piece);
        json_close(w, ']');
    }
    json_ends(w, "]}}");
}

void motion_write(text *out, const graze_motion *motion) {
    json_writer w = motion_begin(out, motion->dimension, "pieces", 0);
    for (size_t k = 0; k < motion->piece_count; k++)
        motion_put_piece(&w, &motion->piece[k]);
    motion_end(&w);
}
