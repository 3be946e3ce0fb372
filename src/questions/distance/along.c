/* Bounds along a covector. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/distance/gap.h"

#include <float.h>
#include <math.h>
#include "questions/distance/time_search.h"

/* A covector whose square is smaller, and so loses digits to underflow, proves no bound; nor does
 * one whose square is above the reciprocal. */
static const double LEAST_SQUARE = 0x1p-600;

double gap_box(const double *m, const box *b) {
    double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += m[i] * (m[i] > 0 ? b->high[i] : b->low[i]);
    return sum;
}

double gap_corners(const double *m, const double *corner, int count, int dimension) {
    double most = -INFINITY;
    for (int c = 0; c < count; c++) {
        double sum = 0;
        for (int i = 0; i < dimension; i++)
            sum += m[i] * corner[c * dimension + i];
        most = larger(most, sum);
    }
    return most;
}

/* Set the numerator m . X - most W, made smaller by its errors; returns 0 if a coefficient is not
 * positive. */
static int numerator(double *out, const window *w, const double *m, double most) {
    int d = w->of->dimension;
    double stray = (fabs(m[0]) + fabs(m[1]) + fabs(m[2])) * w->stray;
    for (int k = 0; k <= w->degree; k++) {
        double value = -most * w->x[d][k];
        for (int i = 0; i < d; i++)
            value += m[i] * w->x[i][k];
        out[k] = value - stray;
        if (!(out[k] > 0))
            return 0;
    }
    return 1;
}

/* Carry a covector by the map's linear part: B m = W A^-T m, coefficient by coefficient. */
static void carry_covector(double (*out)[3], const window *w, const double *m) {
    int d = w->of->dimension;
    for (int k = 0; k <= w->degree; k++)
        for (int j = 0; j < 3; j++) {
            out[k][j] = 0;
            for (int i = 0; i < d && j < d; i++)
                out[k][j] += m[i] * w->linear[i * d + j][k];
        }
}

/* On a piece that is not rigid: numerator / |B m|, by squares. |B m| is below 2^503, so its square
 * is a double; a greater square of the numerator is replaced by the greatest double. */
static double along_placed(const window *w, const double *m, const double *value) {
    double b[WINDOW_ROOM][3], top[SQUARE_ROOM], below[SQUARE_ROOM], least = INFINITY;
    double shortest = INFINITY;
    int n = w->degree;
    carry_covector(b, w, m);
    square_numbers(top, value, n);
    square_vectors(below, (const double(*)[3])b, n);
    for (int k = 0; k <= 2 * n; k++) {
        if (!(below[k] > 0))
            return 0;
        least = smaller(least, smaller(top[k], DBL_MAX) / below[k]);
        shortest = smaller(shortest, below[k]);
    }
    double stray = 2 * w->linear_stray * (fabs(m[0]) + fabs(m[1]) + fabs(m[2]));
    double most = 0;
    for (int k = 0; k <= n; k++)
        most = larger(most, dot3(b[k], b[k]));
    return sqrt(least) / (1 + (stray + SQUARE_ERROR * most / sqrt(shortest)) / sqrt(shortest));
}

double gap_along(const window *w, const double *m, double most) {
    int d = w->of->dimension;
    double square = dot3(m, m), value[WINDOW_ROOM] = {0}, least = INFINITY;
    if (!(square > LEAST_SQUARE && square < 1 / LEAST_SQUARE) || !numerator(value, w, m, most))
        return 0;
    if (!w->of->rigid && w->degree > SQUARED)
        return 0;
    if (!w->of->rigid)
        least = along_placed(w, m, value);
    for (int k = 0; k <= w->degree && w->of->rigid; k++)
        least = smaller(least, value[k] / (w->x[d][k] + w->most_w));
    double out = (w->of->rigid ? least / sqrt(square) : least) * ROUNDED_DOWN;
    return out > 0 ? out : 0;
}
