/* Computes Phi_1 = -A^-1 (A' y + b') and Phi_(k+1) = Delta Phi_k' - k Delta' Phi_k + Phi_k Phi_1.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "questions/envelope/sign_events.h"

static void add_field_product(fmpz_poly_struct *out, const fmpz_poly_struct *a,
                              const fmpz_poly_struct *b) {
    LOCAL(fmpz_poly, product);
    fmpz_poly_mul(product, a, b);
    fmpz_poly_add(out, out, product);
}

/* Phi_1 = -A^-1 (N' W - N W') for the entries N and the weight W of the forward map; Delta is W^2
 * times the inverse map's weight. */
static void set_velocity(derivatives *f, const motion_piece *piece) {
    const point_map *to = &piece->forward, *back = &piece->inverse;
    int d = f->dimension, columns = d + 1;
    LOCAL(fmpz_poly, rate);
    for (int j = 0; j < d; j++)
        for (int c = 0; c < columns; c++) {
            wronskian(rate, &to->entry[j * columns + c], to->weight);
            for (int i = 0; i < d; i++)
                add_field_product(&f->entry[0][i * columns + c], &back->entry[i * columns + j],
                                  rate);
        }
    fmpz_poly_mul(&f->delta, to->weight, to->weight);
    fmpz_poly_mul(&f->delta, &f->delta, back->weight);
}

/* Divide Phi_1 and Delta by the common divisor of all their polynomials; Delta stays positive. */
static void reduce_velocity(derivatives *f) {
    int n = f->dimension * (f->dimension + 1);
    LOCAL(fmpz_poly, common);
    fmpz_poly_set(common, &f->delta);
    for (int k = 0; k < n; k++)
        fmpz_poly_gcd(common, common, &f->entry[0][k]);
    fmpz_poly_div(&f->delta, &f->delta, common);
    LOCAL(fmpz, value);
    fmpz_poly_get_coeff_fmpz(value, &f->delta, 0);
    if (fmpz_sgn(value) < 0) {
        fmpz_poly_neg(common, common);
        fmpz_poly_neg(&f->delta, &f->delta);
    }
    for (int k = 0; k < n; k++)
        fmpz_poly_div(&f->entry[0][k], &f->entry[0][k], common);
}

/* Set Phi_(k+1) from Phi_k, k >= 1. */
static void set_next(derivatives *f, int k) {
    int d = f->dimension, columns = d + 1;
    LOCAL(fmpz_poly, slope);
    LOCAL(fmpz_poly, term);
    fmpz_poly_derivative(slope, &f->delta);
    fmpz_poly_scalar_mul_si(slope, slope, -k);
    for (int i = 0; i < d; i++)
        for (int c = 0; c < columns; c++) {
            fmpz_poly_struct *out = &f->entry[k][i * columns + c];
            const fmpz_poly_struct *row = &f->entry[k - 1][i * columns];
            fmpz_poly_derivative(term, row + c);
            add_field_product(out, term, &f->delta);
            add_field_product(out, row + c, slope);
            for (int j = 0; j < d; j++)
                add_field_product(out, row + j, &f->entry[0][j * columns + c]);
        }
}

/* Apply entry k of the field, Phi_(k+1), to a vertex's homogeneous integers. */
static void set_vertex(fmpz_poly_struct *out, const derivatives *f, int k, const fmpz *x) {
    int d = f->dimension;
    for (int i = 0; i < d; i++)
        for (int c = 0; c <= d; c++)
            fmpz_poly_scalar_addmul_fmpz(out + i, &f->entry[k][i * (d + 1) + c], x + c);
}

static size_t vertex_polynomials(const derivatives *f) {
    return f->cells->vertex_count * FIELD_ORDERS * (size_t)f->dimension;
}

graze_status piece_field_make(derivatives *out, graze_context *context, const motion_piece *piece,
                              const cell_complex *cells) {
    out->cells = cells;
    out->dimension = cells->dimension;
    for (int k = 0; k < FIELD_ORDERS; k++)
        for (int i = 0; i < POINT_MAP_ENTRIES; i++)
            fmpz_poly_init(&out->entry[k][i]);
    fmpz_poly_init(&out->delta);
    size_t count = vertex_polynomials(out);
    TRY(MAKE_ARRAY(context, out->vertex, count, "the speeds of vertices"));
    for (size_t k = 0; k < count; k++)
        fmpz_poly_init(out->vertex + k);
    set_velocity(out, piece);
    reduce_velocity(out);
    for (int k = 1; k < FIELD_ORDERS; k++)
        set_next(out, k);
    for (size_t v = 0; v < cells->vertex_count; v++)
        for (int k = 0; k < FIELD_ORDERS; k++)
            set_vertex(out->vertex + (v * FIELD_ORDERS + (size_t)k) * (size_t)out->dimension, out,
                       k, cells->vertex[v].x);
    return GRAZE_OK;
}

void derivatives_clear(derivatives *f) {
    for (int k = 0; k < FIELD_ORDERS; k++)
        for (int i = 0; i < POINT_MAP_ENTRIES; i++)
            fmpz_poly_clear(&f->entry[k][i]);
    fmpz_poly_clear(&f->delta);
    for (size_t k = 0; f->vertex && k < vertex_polynomials(f); k++)
        fmpz_poly_clear(f->vertex + k);
    free(f->vertex);
    f->vertex = NULL;
}

const fmpz_poly_struct *derivatives_at(const derivatives *f, int k, size_t vertex) {
    return f->vertex + (vertex * FIELD_ORDERS + (size_t)(k - 1)) * (size_t)f->dimension;
}

void derivatives_along(fmpz_poly_t out, const derivatives *f, int k, size_t facet, size_t vertex) {
    const fmpz_poly_struct *at = derivatives_at(f, k, vertex);
    const fmpz *normal = f->cells->facet[facet].normal;
    fmpz_poly_zero(out);
    for (int i = 0; i < f->dimension; i++)
        fmpz_poly_scalar_addmul_fmpz(out, at + i, normal + i);
}

void derivatives_velocity(fmpz_poly_t out, const derivatives *f, size_t facet, size_t vertex) {
    derivatives_along(out, f, 1, facet, vertex);
    fmpz_poly_neg(out, out);
}
