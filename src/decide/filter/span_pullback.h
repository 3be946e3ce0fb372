/* A polynomial on a span, in Bernstein form and in doubles: its signs, and its one root.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_SPAN_PULLBACK_H
#define GRAZE_FILTER_SPAN_PULLBACK_H

/** Polynomials of higher degree are left to the exact path; up to this degree all binomials are
 * doubles.
 */
enum { PULLBACK_DEGREE = 56 };

/** Coefficients 0 to `degree`, with bounds of all their errors and of their absolute values. */
typedef struct pullback {
    int degree;
    double *at;
    double error, size;
} pullback;

/** A window [low, high] of a span's parameter, in [0, 1]; `enters`: the crossing is from outside to
 * inside. */
typedef struct meet_window {
    double low, high;
    int enters;
} meet_window;

/** Conclusions from the signs of the coefficients. */
typedef struct pullback_signs {
    int first, last; /* of the coefficients 0 and n; 0: not certain */
    int one;         /* all have the sign `first` */
    int single;      /* they change once, whatever the sign of the one that may be uncertain */
} pullback_signs;

/** The sign of a value with an error; 0 where it is not certain. */
static inline int pullback_sign(double value, double error) {
    return value > error ? 1 : value < -error ? -1 : 0;
}

/** Set the size from the coefficients. */
void pullback_measure(pullback *p);

/** Subdivide coefficients of degree n into those of both halves. */
void pullback_halve(double *left, double *right, const double *x, int n);

pullback_signs pullback_read(const pullback *p);

/** Find a window with certain ends around the one root of a pullback whose signs are `single`; 0 if
 * none is found. `enters` is unchanged (proofs/filter.md C36). */
int pullback_window(meet_window *out, const pullback *p);

#endif
