/* Arithmetic in doubles whose errors are bounded (proofs/filter.md C32): constants, small vectors.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_DOUBLES_H
#define GRAZE_NUMBER_DOUBLES_H

#include <math.h>

/** The filter's unit of rounding, 2^-53 (proofs/filter.md C32). */
#define UNIT_ROUNDING 0x1p-53

/** Factor that covers the rounding of error terms. */
#define FILTER_SLACK (1 + 0x1p-20)

/** Bound of the error that underflow, and numbers too small to convert, add to a coefficient. */
#define FILTER_FLOOR 0x1p-780

/* The larger and the smaller of two numbers that are not NaN, inline. */
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

#endif
