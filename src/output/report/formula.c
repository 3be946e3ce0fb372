/* Polynomials and rational functions of the motion's parameter as text.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A piece's maps are polynomials in its own parameter u. To write them in the motion's parameter t,
 * u = (t - lo)/(hi - lo) is substituted and the quotient brought to lowest terms. Coefficients are
 * exact; where terms or digits are left out, the text says how many.
 */
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "output/report/row_parts.h"

enum { LONG_NUMBER = 40, SHOWN_FIGURES = 12, LONG_POLYNOMIAL = 9, SHOWN_TERMS = 3 };

static void put_figures(text *out, const char *figures) {
    size_t length = strlen(figures);
    if (length <= LONG_NUMBER) {
        text_put(out, figures);
        return;
    }
    text_bytes(out, figures, SHOWN_FIGURES);
    text_put(out, "...");
    text_put(out, figures + length - SHOWN_FIGURES);
    text_format(out, "[%zu digits]", length);
}

void formula_rational(text *out, const fmpq_t value) {
    char *number = rational_text(value);
    if (!number) {
        out->failed = 1;
        return;
    }
    char *figures = number, *bar = strchr(number, '/');
    if (*figures == '-') {
        text_put(out, "-");
        figures++;
    }
    if (bar)
        *bar = '\0';
    put_figures(out, figures);
    if (bar) {
        text_put(out, "/");
        put_figures(out, bar + 1);
    }
    free(number);
}

/* Append a term. In the variable `whole`, unless it is NULL, nothing is left out. */
static void put_term(text *out, const fmpq_t coefficient, slong power, int first,
                     const char *whole) {
    LOCAL(fmpq, size);
    fmpq_abs(size, coefficient);
    if (first)
        text_put(out, fmpq_sgn(coefficient) < 0 ? "-" : "");
    else
        text_put(out, fmpq_sgn(coefficient) < 0 ? " - " : " + ");
    int unit = fmpq_is_one(size) && power > 0 && !whole;
    if (whole)
        text_rational(out, size);
    else if (!unit)
        formula_rational(out, size);
    if (power > 0)
        text_format(out, unit ? "%s" : "*%s", whole ? whole : "t");
    if (power > 1)
        text_format(out, "^%ld", (long)power);
}

static slong term_count(const fmpq_poly_t p) {
    slong count = 0;
    for (slong k = 0; k < fmpq_poly_length(p); k++)
        count += !fmpz_is_zero(fmpq_poly_numref(p) + k);
    return count;
}

static void put_polynomial(text *out, const fmpq_poly_t p, const char *whole) {
    slong count = term_count(p), seen = 0;
    LOCAL(fmpq, coefficient);
    if (count == 0)
        text_put(out, "0");
    for (slong k = fmpq_poly_degree(p); k >= 0; k--) {
        fmpq_poly_get_coeff_fmpq(coefficient, p, k);
        if (fmpq_is_zero(coefficient))
            continue;
        seen++;
        if (whole || count <= LONG_POLYNOMIAL || seen <= SHOWN_TERMS || seen > count - SHOWN_TERMS)
            put_term(out, coefficient, k, seen == 1, whole);
        else if (seen == SHOWN_TERMS + 1)
            text_format(out, " + ... [%ld terms left out] ...", (long)(count - 2 * SHOWN_TERMS));
    }
}

void formula_polynomial(text *out, const fmpz_poly_t polynomial) {
    LOCAL(fmpq_poly, p);
    fmpq_poly_set_fmpz_poly(p, polynomial);
    put_polynomial(out, p, NULL);
}

/* Numerator and weight of one coordinate as polynomials in u. */
static void coordinate_in_u(fmpq_poly_t numerator, fmpq_poly_t weight, const point_map *map,
                            int coordinate, const fmpq *point) {
    int d = map->dimension;
    const fmpz_poly_struct *row = map->entry + coordinate * (d + 1);
    LOCAL(fmpq_poly, term);
    fmpq_poly_set_fmpz_poly(numerator, row + d);
    for (int j = 0; j < d; j++) {
        fmpq_poly_set_fmpz_poly(term, row + j);
        fmpq_poly_scalar_mul_fmpq(term, term, point + j);
        fmpq_poly_add(numerator, numerator, term);
    }
    fmpq_poly_set_fmpz_poly(weight, map->weight);
}

/* Substitute u = (t - lo)/(hi - lo) in numerator and weight, unless `piece` is NULL, divide both by
 * their common factor, and scale them so that the weight is a primitive integer polynomial with
 * positive leading coefficient. */
static void to_lowest_terms(fmpq_poly_t numerator, fmpq_poly_t weight, const motion_piece *piece) {
    LOCAL_VEC(fmpq, slope, 2);
    fmpq *shift = slope + 1;
    LOCAL(fmpq_poly, local);
    LOCAL(fmpq_poly, factor);
    if (piece) {
        fmpq_sub(slope, piece->hi, piece->lo);
        fmpq_inv(slope, slope);
        fmpq_mul(shift, piece->lo, slope);
        fmpq_neg(shift, shift);
        fmpq_poly_set_coeff_fmpq(local, 1, slope);
        fmpq_poly_set_coeff_fmpq(local, 0, shift);
        fmpq_poly_compose(numerator, numerator, local);
        fmpq_poly_compose(weight, weight, local);
    }
    fmpq_poly_gcd(factor, numerator, weight);
    if (fmpq_poly_degree(factor) > 0) {
        fmpq_poly_div(numerator, numerator, factor);
        fmpq_poly_div(weight, weight, factor);
    }
    fmpq_poly_content(slope, weight);
    if (fmpz_sgn(fmpq_poly_numref(weight) + fmpq_poly_degree(weight)) < 0)
        fmpq_neg(slope, slope);
    fmpq_inv(slope, slope);
    fmpq_poly_scalar_mul_fmpq(weight, weight, slope);
    fmpq_poly_scalar_mul_fmpq(numerator, numerator, slope);
}

void formula_quotient(text *out, fmpq_poly_t numerator, fmpq_poly_t weight,
                      const motion_piece *piece, const char *whole) {
    to_lowest_terms(numerator, weight, piece);
    if (fmpq_poly_degree(weight) <= 0) {
        fmpq_poly_div(numerator, numerator, weight);
        put_polynomial(out, numerator, whole);
        return;
    }
    int several = whole || term_count(numerator) > 1;
    text_put(out, several ? "(" : "");
    put_polynomial(out, numerator, whole);
    text_put(out, several ? ")/(" : "/(");
    put_polynomial(out, weight, whole);
    text_put(out, ")");
}

void formula_coordinate(text *out, const motion_piece *piece, const point_map *map, int coordinate,
                        const fmpq *point) {
    LOCAL(fmpq_poly, numerator);
    LOCAL(fmpq_poly, weight);
    coordinate_in_u(numerator, weight, map, coordinate, point);
    formula_quotient(out, numerator, weight, piece, NULL);
}
