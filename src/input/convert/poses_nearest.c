/* The rotation nearest to a matrix, and how near it is.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/convert/poses_list.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/vector.h"

/* The symmetric matrix K with x K x = (trace of R(x)^T A) |x|^2 for every quaternion x. */
static void horn(double k[4][4], const double a[9]) {
    double lower[4][4] = {{a[0] + a[4] + a[8], 0, 0, 0},
                          {a[7] - a[5], a[0] - a[4] - a[8], 0, 0},
                          {a[2] - a[6], a[1] + a[3], a[4] - a[0] - a[8], 0},
                          {a[3] - a[1], a[2] + a[6], a[5] + a[7], a[8] - a[0] - a[4]}};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            k[i][j] = i >= j ? lower[i][j] : lower[j][i];
}

/* One sweep of Jacobi's rotations: K becomes more diagonal, V collects the eigenvectors. */
static void sweep(double k[4][4], double v[4][4]) {
    for (int p = 0; p < 4; p++)
        for (int q = p + 1; q < 4; q++) {
            if (k[p][q] == 0)
                continue;
            double theta = (k[q][q] - k[p][p]) / (2 * k[p][q]);
            double t = (theta < 0 ? -1 : 1) / (fabs(theta) + hypot(theta, 1));
            double c = 1 / hypot(t, 1), s = t * c;
            for (int i = 0; i < 4; i++) {
                double x = k[i][p], y = k[i][q];
                k[i][p] = c * x - s * y;
                k[i][q] = s * x + c * y;
                x = v[i][p], y = v[i][q];
                v[i][p] = c * x - s * y;
                v[i][q] = s * x + c * y;
            }
            for (int i = 0; i < 4; i++) {
                double x = k[p][i], y = k[q][i];
                k[p][i] = c * x - s * y;
                k[q][i] = s * x + c * y;
            }
        }
}

void pose_nearest(double out[4], const double matrix[9], const double before[4]) {
    double k[4][4], v[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    int best = 0;
    horn(k, matrix);
    for (int rounds = 0; rounds < 12; rounds++) /* Jacobi's method converges quadratically: 6 are
                                                 * enough */
        sweep(k, v);
    for (int i = 1; i < 4; i++)
        best = k[i][i] > k[best][best] ? i : best;
    double along = 0;
    for (int i = 0; i < 4; i++)
        along += v[i][best] * before[i];
    for (int i = 0; i < 4; i++)
        out[i] = along < 0 ? -v[i][best] : v[i][best];
}

/* out = (2 (a b + sign c d)) / norm */
static void matrix_entry(fmpq_t out, const fmpq *a, const fmpq *b, int sign, const fmpq *c,
                         const fmpq *d, const fmpq_t norm) {
    fmpq_mul(out, a, b);
    (sign > 0 ? fmpq_addmul : fmpq_submul)(out, c, d);
    fmpq_add(out, out, out);
    fmpq_div(out, out, norm);
}

void pose_rotation(fmpq *out, const fmpq *q) {
    LOCAL(fmpq, norm);
    _fmpq_vec_dot(norm, q, q, 4);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            fmpq *entry = out + 3 * i + j;
            if (i == j) {
                matrix_entry(entry, q, q, 1, q + 1 + i, q + 1 + i, norm);
                fmpq_sub_si(entry, entry, 1);
            } else {
                matrix_entry(entry, q + 1 + i, q + 1 + j, (j - i + 3) % 3 == 1 ? -1 : 1, q,
                             q + 1 + (3 - i - j), norm);
            }
        }
}

void rotation_distance(fmpq_t out, const fmpq *rotation, const fmpq *matrix, int columns) {
    LOCAL_VEC(fmpq, difference, 9);
    for (int row = 0; row < 3; row++)
        vector_sub(difference + 3 * row, rotation + 3 * row, matrix + columns * row, 3);
    vector_widest(out, difference, 9);
}
