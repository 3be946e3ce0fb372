/* A motion as plain pieces: every entry a quotient of polynomials in the motion's own parameter.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/motion/motion.h"

#include <flint/fmpq_poly.h>
#include <flint/fmpq_vec.h>
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

/* c_0 + c_1*t - c_2*t^2, terms that are zero left out. */
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

/* entry / weight; the polynomials are first multiplied by `scale`. */
static void write_entry(text *out, const fmpz_poly_t entry, const fmpq_poly_t weight,
                        const fmpz_t scale, const motion_piece *piece) {
    LOCAL(fmpq_poly, p);
    in_time(p, entry, piece);
    text_put(out, "\"");
    if (fmpq_poly_length(weight) == 1) {
        fmpq_poly_div(p, p, weight);
        write_poly(out, p);
    } else {
        fmpq_poly_scalar_mul_fmpz(p, p, scale);
        text_put(out, "(");
        write_poly(out, p);
        text_put(out, ")/(");
        fmpq_poly_scalar_mul_fmpz(p, weight, scale);
        write_poly(out, p);
        text_put(out, ")");
    }
    text_put(out, "\"");
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

static void write_piece(text *out, const motion_piece *piece) {
    const point_map *m = &piece->forward;
    int d = m->dimension;
    LOCAL(fmpq_poly, weight);
    LOCAL(fmpz, scale);
    in_time(weight, m->weight, piece);
    find_scale(scale, piece);
    text_put(out, "  {\"t\": [\"");
    text_rational(out, piece->lo);
    text_put(out, "\", \"");
    text_rational(out, piece->hi);
    text_put(out, "\"], ");
    if (piece->row)
        text_format(out, "\"row\": %lu, ", piece->row);
    text_put(out, "\"transform\": {\"matrix\": [\n");
    for (int i = 0; i < d; i++) {
        for (int k = 0; k <= d; k++) {
            text_put(out, k == 0 ? "    [" : ", ");
            write_entry(out, m->entry + i * (d + 1) + k, weight, scale, piece);
        }
        text_put(out, i + 1 < d ? "],\n" : "]]}}");
    }
}

void motion_write(text *out, const graze_motion *motion) {
    text_format(out, "{\"dimension\": %d, \"pieces\": [\n", motion->dimension);
    for (size_t k = 0; k < motion->piece_count; k++) {
        write_piece(out, &motion->piece[k]);
        text_put(out, k + 1 < motion->piece_count ? ",\n" : "\n");
    }
    text_put(out, "]}\n");
}
