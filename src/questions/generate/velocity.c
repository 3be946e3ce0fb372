/* Proves in doubles that the normal velocity has one sign on a simplex (proofs/doubles.md C64).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/generate/strata.h"

#include <math.h>

/* A number and a bound for its error. */
typedef struct approximate {
    double at, off;
} approximate;

/* Row `row` of the instant's first derivative, applied to a corner. */
static approximate carry_corner(const instant *i, int row, const double *corner, double error) {
    int d = i->dimension;
    const double *entry = i->velocity + row * (d + 1);
    approximate out = {entry[d], 0};
    double size = fabs(entry[d]), blur = 0;
    for (int j = 0; j < d; j++) {
        out.at += entry[j] * corner[j];
        size += fabs(entry[j] * corner[j]);
        blur += fabs(entry[j]);
    }
    out.off = FILTER_SLACK * (8 * UNIT_ROUNDING * size + blur * error) + FILTER_FLOOR;
    return out;
}

/* The normal velocity of a corner against the simplex's plane, through its first corner. */
static approximate corner_velocity(const instant *i, const normal *n, const double *first,
                                   const double *corner, double error) {
    int d = i->dimension;
    approximate weight = carry_corner(i, d, corner, error), out = {0, 0};
    for (int k = 0; k < d; k++) {
        approximate x = carry_corner(i, k, corner, error);
        double shift = first[k] * weight.at, step = x.at - shift;
        double off = x.off + (fabs(first[k]) + error) * weight.off + error * fabs(weight.at) +
                     4 * UNIT_ROUNDING * (fabs(x.at) + fabs(shift));
        out.at += n->at[k] * step;
        out.off += (fabs(n->at[k]) + n->error) * off + n->error * fabs(step) +
                   4 * UNIT_ROUNDING * fabs(n->at[k] * step);
    }
    out.off = FILTER_SLACK * out.off + FILTER_FLOOR;
    return out;
}

int velocity_has_one_sign(const instant *i, const graze_solid *solid, size_t simplex) {
    const corners *corners = &solid->corners;
    size_t d = (size_t)i->dimension;
    if (!corners->at || !i->bounded)
        return 0;
    const double *first = corners->at + simplex * d * d;
    int positive = 1, negative = 1;
    normal n;
    normal_of(&n, first, corners->error, i->dimension);
    for (size_t c = 0; c < d; c++) {
        approximate v = corner_velocity(i, &n, first, first + c * d, corners->error);
        positive = positive && v.at > v.off;
        negative = negative && v.at < -v.off;
    }
    return positive || negative;
}
