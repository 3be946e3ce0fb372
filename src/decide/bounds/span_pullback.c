/* Signs of Bernstein coefficients, and windows of simple roots. The error bounds are those of
 * proofs/filter.md (C33 (c), C36). A comparison that is false for NaN never decides.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/bounds/bounds.h"

#include <math.h>
#include <string.h>

#define U UNIT_ROUNDING
#define SLACK FILTER_SLACK

void pullback_measure(pullback *p) {
    p->size = 0;
    for (int k = 0; k <= p->degree; k++)
        p->size = larger(p->size, fabs(p->at[k]));
}

/* Averages of neighbours, level after level: one rounding each. */
void pullback_halve(double *left, double *right, const double *x, int n) {
    for (int k = 0; k <= n; k++)
        right[k] = x[k];
    left[0] = x[0];
    for (int level = 1; level <= n; level++) {
        for (int k = 0; k <= n - level; k++)
            right[k] = 0.5 * (right[k] + right[k + 1]);
        left[level] = right[0];
    }
}

/* The value and the certain sign of the pullback at s; the error is that of the coefficients and of
 * de Casteljau's scheme. */
static int sign_on_span(const pullback *p, double s, double *value) {
    int n = p->degree;
    double row[PULLBACK_DEGREE + 1];
    memcpy(row, p->at, (size_t)(n + 1) * sizeof *row);
    for (int level = 1; level <= n; level++)
        for (int k = 0; k <= n - level; k++)
            row[k] += s * (row[k + 1] - row[k]);
    *value = row[0];
    return pullback_sign(row[0], SLACK * (p->error + 5 * n * U * p->size));
}

/* A guess at the root between two places of opposite sign: the Illinois method. */
static double guess_root(const pullback *p) {
    double low = 0, high = 1, at_low = p->at[0], at_high = p->at[p->degree];
    double s = at_low / (at_low - at_high), value;
    int kept = 0;
    for (int step = 0; step < 24 && p->degree > 1; step++) {
        if (sign_on_span(p, s, &value) == 0)
            break;
        if ((value > 0) == (at_low > 0)) {
            low = s;
            at_low = value;
            at_high *= kept > 0 ? 0.5 : 1;
            kept = 1;
        } else {
            high = s;
            at_high = value;
            at_low *= kept < 0 ? 0.5 : 1;
            kept = -1;
        }
        double next = (low * at_high - high * at_low) / (at_high - at_low);
        if (!(fabs(next - s) > 0x1p-40))
            break;
        s = next;
    }
    return s;
}

int pullback_window(meet_window *out, const pullback *p) {
    int n = p->degree, before = p->at[0] > 0 ? 1 : -1;
    double s = guess_root(p), value;
    double width = 0x1p-48 + 4 * p->error / fabs(p->at[n] - p->at[0]);
    for (int attempt = 0; attempt < 8; attempt++, width *= 32) {
        out->low = s - width > 0 ? s - width : 0;
        out->high = s + width < 1 ? s + width : 1;
        if ((out->low == 0 || sign_on_span(p, out->low, &value) == before) &&
            (out->high == 1 || sign_on_span(p, out->high, &value) == -before))
            return 1;
    }
    return 0;
}

pullback_signs pullback_read(const pullback *p) {
    int n = p->degree;
    enum { FIRST_RUN, UNCERTAIN, LAST_RUN };
    int before = FIRST_RUN;
    pullback_signs s = {pullback_sign(p->at[0], p->error), pullback_sign(p->at[n], p->error), 1, 0};
    s.one = s.first != 0;
    s.single = s.first * s.last < 0;
    for (int k = 0; k <= n; k++) {
        int sign = pullback_sign(p->at[k], p->error);
        int here = sign == 0 ? UNCERTAIN : sign == s.first ? FIRST_RUN : LAST_RUN;
        s.one = s.one && sign == s.first;
        /* An uncertain coefficient among those of one sign could be of the other: three changes. */
        s.single = s.single && here >= before && !(here == UNCERTAIN && before == UNCERTAIN);
        before = here;
    }
    return s;
}
