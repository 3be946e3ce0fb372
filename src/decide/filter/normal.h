/* The normal of a simplex in doubles, and the constants of the filter's error bounds.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_NORMAL_H
#define GRAZE_FILTER_NORMAL_H

#include <math.h>
#include "decide/filter/carrier.h"

/** Factor that covers the rounding of error terms. */
#define FILTER_SLACK (1 + 0x1p-20)

/** Bound of the error that underflow, and numbers too small to convert, add to a coefficient. */
#define FILTER_FLOOR 0x1p-780

/** The normal of a simplex's plane, outward, and a bound for the error of each coordinate
 * (proofs/filter.md C35). */
typedef struct normal {
    double at[3], error;
} normal;

/* fmax and fmin without the call. */
static inline double larger(double a, double b) {
    return a > b ? a : b;
}
static inline double smaller(double a, double b) {
    return a < b ? a : b;
}

static inline double dot3(const double *a, const double *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross3(double *out, const double *a, const double *b) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/** The distance of two points, rounded up to cover the errors of squares and root, but not those of
 * the differences of coordinates. */
static inline double distance_above(const double *a, const double *b) {
    double off[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return sqrt(dot3(off, off)) * (1 + 0x1p-48);
}

static inline double largest3(const double *x) {
    return larger(fabs(x[0]), larger(fabs(x[1]), fabs(x[2])));
}

/** The normal of a segment in E^2. */
static inline void normal_plane(normal *out, const double *v, double corner_error) {
    out->at[0] = v[3] - v[1];
    out->at[1] = v[0] - v[2];
    out->at[2] = 0;
    out->error =
        FILTER_SLACK * (UNIT_ROUNDING * largest3(out->at) + 2 * corner_error) + FILTER_FLOOR;
}

/** The normal of a triangle in E^3. */
static inline void normal_space(normal *out, const double *v, double corner_error) {
    double a[3], b[3];
    for (int i = 0; i < 3; i++) {
        a[i] = v[3 + i] - v[i];
        b[i] = v[6 + i] - v[i];
    }
    cross3(out->at, a, b);
    double la = largest3(a), lb = largest3(b);
    out->error = FILTER_SLACK * (9 * UNIT_ROUNDING * la * lb + 4 * corner_error * (la + lb) +
                                 8 * corner_error * corner_error) +
                 FILTER_FLOOR;
}

static inline void normal_of(normal *out, const double *v, double corner_error, int dimension) {
    if (dimension == 2)
        normal_plane(out, v, corner_error);
    else
        normal_space(out, v, corner_error);
}

/** The coordinate along which a simplex is projected; -1 if its size is not certain. */
static inline int normal_axis(const normal *n, int dimension) {
    if (dimension == 2)
        return 0;
    double x = fabs(n->at[0]), y = fabs(n->at[1]), z = fabs(n->at[2]);
    int axis = y > x ? 1 : 0;
    double most = y > x ? y : x;
    axis = z > most ? 2 : axis;
    most = z > most ? z : most;
    return most > n->error ? axis : -1;
}

#endif
