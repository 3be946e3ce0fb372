/* Products by binomial means. SPDX-License-Identifier: GPL-3.0-or-later */
#include "distance/square.h"

/* share[k][l] = C(n, k) C(n, l) / C(2n, k + l). */
static double binomial_share(const double *half, const double *whole, int k, int l) {
    return half[k] * half[l] / whole[k + l];
}

static void binomials(double *out, int n) {
    out[0] = 1;
    for (int k = 1; k <= n; k++)
        out[k] = out[k - 1] * (n + 1 - k) / k;
}

void square_numbers(double *out, const double *c, int n) {
    double half[SQUARE_ROOM], whole[SQUARE_ROOM];
    binomials(half, n);
    binomials(whole, 2 * n);
    for (int m = 0; m <= 2 * n; m++)
        out[m] = 0;
    for (int k = 0; k <= n; k++)
        for (int l = 0; l <= n; l++)
            out[k + l] += binomial_share(half, whole, k, l) * c[k] * c[l];
}

void product_vectors(double *out, const double (*a)[3], const double (*b)[3], int n) {
    double half[SQUARE_ROOM], whole[SQUARE_ROOM];
    binomials(half, n);
    binomials(whole, 2 * n);
    for (int m = 0; m <= 2 * n; m++)
        out[m] = 0;
    for (int k = 0; k <= n; k++)
        for (int l = 0; l <= n; l++)
            out[k + l] += binomial_share(half, whole, k, l) * dot3(a[k], b[l]);
}

void square_vectors(double *out, const double (*c)[3], int n) {
    product_vectors(out, c, c, n);
}
