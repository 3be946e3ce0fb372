/* One span against one simplex, in doubles with proven bounds.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The signs of the pullback of the simplex's plane in Bernstein form decide; the simplex's sides
 * are evaluated at the window of a root, or on the whole span, only. The error bounds are those of
 * proofs/filter.md (C35). A comparison that is false for NaN never decides.
 */
#include <math.h>
#include "decide/filter/search.h"

#define U UNIT_ROUNDING
#define SLACK FILTER_SLACK
#define FLOOR FILTER_FLOOR

typedef struct meeter {
    const curve *c;
    const span *piece;
    const double *corner;
    double corner_error;
    normal normal;
    shift_bound shift;
    double at[CARRIER_DEGREE + 1];
    pullback plane;
} meeter;

/* Set `plane` to the pullback n . (X - v_0 W) of the simplex's plane, coefficient by coefficient.
 */
static void make_plane(meeter *m) {
    int d = m->c->dimension, n = m->piece->degree;
    const double *w = curve_coefficients(m->c, m->piece, d);
    double norm = 0;
    pullback *p = &m->plane;
    *p = (pullback){.degree = n, .at = m->at};
    for (int i = 0; i < d; i++) {
        const double *x = curve_coefficients(m->c, m->piece, i);
        double a = m->normal.at[i], v = m->corner[i];
        norm += fabs(a);
        for (int k = 0; k <= n; k++)
            p->at[k] = (i ? p->at[k] : 0) + a * (x[k] - v * w[k]);
    }
    const shift_bound *s = &m->shift;
    p->error =
        SLACK * (norm * (s->error + 4 * U * s->size) + 3 * m->normal.error * (s->size + s->error)) +
        FLOOR;
    pullback_measure(p);
}

/* Two coordinates of D = X - v W, each within `error` of the exact one. */
typedef struct shifted {
    double i, j, error;
} shifted;

/* Sign of the form of side k, positive inside, at a place shifted by the side's first corner. The
 * side's direction is taken from the corners; in E^3 both are projected along coordinate `drop` of
 * the normal. */
static int side_sign(const meeter *m, int k, int drop, const shifted *at) {
    double ev = m->corner_error, size = fabs(at->i) + fabs(at->j) + 2 * at->error, value, length;
    if (m->c->dimension == 2) {
        double ei = m->corner[2] - m->corner[0], ej = m->corner[3] - m->corner[1];
        length = fabs(ei) + fabs(ej);
        value = ei * at->i + ej * at->j;
        value = k == 0 ? value : -value;
    } else {
        const double *v = m->corner + 3 * k, *next = m->corner + 3 * ((k + 1) % 3);
        int i = (drop + 1) % 3, j = (drop + 2) % 3;
        double ei = next[i] - v[i], ej = next[j] - v[j];
        length = fabs(ei) + fabs(ej);
        value = ei * at->j - ej * at->i;
        value = m->normal.at[drop] > 0 ? value : -value;
    }
    double error = SLACK * (length * (at->error + 8 * U * size) + 4 * ev * size) + FLOOR;
    return pullback_sign(value, error);
}

/* The coordinates `i` and `j` of `shifted` that side_sign reads. */
static int first_axis(const meeter *m, int drop) {
    return m->c->dimension == 2 ? 0 : (drop + 1) % 3;
}
static int second_axis(const meeter *m, int drop) {
    return m->c->dimension == 2 ? 1 : (drop + 2) % 3;
}

/* Is it certain that the whole span is beyond one side of the simplex? */
static int is_beside(const meeter *m, int drop) {
    int d = m->c->dimension, n = m->piece->degree, i = first_axis(m, drop),
        j = second_axis(m, drop);
    const double *w = curve_coefficients(m->c, m->piece, d);
    const double *xi = curve_coefficients(m->c, m->piece, i);
    const double *xj = curve_coefficients(m->c, m->piece, j);
    for (int side = 0; side < d; side++) {
        const double *v = m->corner + d * side;
        int beyond = 1;
        for (int k = 0; k <= n && beyond; k++) {
            shifted at = {xi[k] - v[i] * w[k], xj[k] - v[j] * w[k], m->shift.error};
            beyond = side_sign(m, side, drop, &at) < 0;
        }
        if (beyond)
            return 1;
    }
    return 0;
}

/* Judge the sides of a simplex as sides_meet describes. */
static int judge_sides(unsigned *inside, const meeter *m, const meet_window *w) {
    int d = m->c->dimension, drop = normal_axis(&m->normal, d);
    *inside = 0;
    if (drop < 0)
        return 1;
    double at[4], error[4], middle = 0.5 * (w->low + w->high);
    double away = (larger(w->high - middle, middle - w->low)) * m->shift.speed;
    curve_at(at, error, m->c, m->piece, middle);
    int i = first_axis(m, drop), j = second_axis(m, drop);
    double e = SLACK * (m->shift.error + 5 * m->piece->degree * U * m->shift.size + away);
    for (int side = 0; side < d; side++) {
        const double *v = m->corner + d * side;
        shifted place = {at[i] - v[i] * at[d], at[j] - v[j] * at[d], e};
        int sign = side_sign(m, side, drop, &place);
        if (flip(FLIP_ROOT_OUTSIDE, sign < 0))
            return 0;
        *inside |= (unsigned)(sign > 0) << side;
    }
    return 1;
}

/* Decide the meeting by the sides of the simplex in the window of the plane's one root. */
static meeting judge_window(const meeter *m, const meet_window *w) {
    unsigned inside, all = (1u << m->c->dimension) - 1;
    if (!judge_sides(&inside, m, w))
        return MEET_NONE;
    return flip(FLIP_ROOT_INSIDE, inside == all) ? MEET_CROSSING : MEET_ASK;
}

static meeter begin_meeter(const curve *c, const span *piece, const double *corner,
                           double corner_error) {
    meeter m = {.c = c, .piece = piece, .corner = corner, .corner_error = corner_error};
    m.shift = curve_shift(c, piece);
    normal_of(&m.normal, corner, corner_error, c->dimension);
    return m;
}

int sides_meet(unsigned *inside, const curve *c, const span *piece, const double *corner,
               double corner_error, const meet_window *at) {
    meeter m = begin_meeter(c, piece, corner, corner_error);
    int meets = judge_sides(inside, &m, at);
    for (int k = 0; k < c->dimension && meets; k++)
        *inside |= (unsigned)flip(FLIP_SIDE_INSIDE, *inside >> k & 1) << k;
    return meets;
}

meeting meet_simplex(meet_window *out, const curve *c, const span *piece, const double *corner,
                     double corner_error) {
    meeter m = begin_meeter(c, piece, corner, corner_error);
    *out = (meet_window){0, 1, 0};
    make_plane(&m);
    pullback_signs s = pullback_read(&m.plane);
    if (flip(FLIP_ONE_SIGN, s.one))
        return MEET_NONE;
    if (flip(FLIP_ONE_ROOT, s.single)) {
        out->enters = flip(FLIP_DIRECTION, s.first > 0);
        if (pullback_window(out, &m.plane))
            return judge_window(&m, out);
        *out = (meet_window){0, 1, 0};
        return MEET_ASK;
    }
    int drop = normal_axis(&m.normal, c->dimension);
    if (flip(FLIP_BESIDE, drop >= 0 && is_beside(&m, drop)))
        return MEET_NONE;
    /* Where errors are not far below the values, halves would be as uncertain. */
    return m.plane.size > 0x1p20 * m.plane.error ? MEET_CUT : MEET_ASK;
}
