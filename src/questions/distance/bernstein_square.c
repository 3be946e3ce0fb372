/* Products by binomial means. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/distance/gap.h"

/* C(n, k), and C(2n, k). */
typedef struct binomials {
    double half[SQUARE_ROOM], whole[SQUARE_ROOM];
} binomials;

static void fill_binomials(double *out, int n) {
    out[0] = 1;
    for (int k = 1; k <= n; k++)
        out[k] = out[k - 1] * (n + 1 - k) / k;
}

/* The binomials for degree n; the 2n + 1 coefficients of a product are zero. */
static void begin_product(binomials *b, double *out, int n) {
    fill_binomials(b->half, n);
    fill_binomials(b->whole, 2 * n);
    for (int m = 0; m <= 2 * n; m++)
        out[m] = 0;
}

static double binomial_share(const binomials *b, int k, int l) {
    return b->half[k] * b->half[l] / b->whole[k + l];
}

void square_numbers(double *out, const double *c, int n) {
    binomials b;
    begin_product(&b, out, n);
    for (int k = 0; k <= n; k++)
        for (int l = 0; l <= n; l++)
            out[k + l] += binomial_share(&b, k, l) * c[k] * c[l];
}

void product_vectors(double *out, const double (*a)[3], const double (*c)[3], int n) {
    binomials b;
    begin_product(&b, out, n);
    for (int k = 0; k <= n; k++)
        for (int l = 0; l <= n; l++)
            out[k + l] += binomial_share(&b, k, l) * dot3(a[k], c[l]);
}

void square_vectors(double *out, const double (*c)[3], int n) {
    product_vectors(out, c, c, n);
}
