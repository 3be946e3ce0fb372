/* One span against one simplex, in doubles with proven bounds.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The signs of the pullback of the simplex's plane in Bernstein form decide; the simplex's sides
 * are evaluated at the window of a root, or on the whole span, only. The error bounds are those of
 * proofs/filter.md (C35). A comparison that is false for NaN never decides.
 */
#include "decide/filter/meet.h"

#include <math.h>
#include <string.h>
#include "decide/filter/flip.h"
#include "decide/filter/normal.h"

#define U UNIT_ROUNDING
#define SLACK FILTER_SLACK
#define FLOOR FILTER_FLOOR

/* A pullback in Bernstein form with one error bound for all coefficients. */
typedef struct pullback {
    double at[CARRIER_DEGREE + 1], error, size;
} pullback;

typedef struct meeter {
    const curve *c;
    const span *piece;
    const double *corner;
    double corner_error;
    normal normal;
    shift_bound shift;
    pullback plane;
} meeter;

/* n . (X - v_0 W), coefficient by coefficient. */
static void make_plane(meeter *m) {
    int d = m->c->dimension, n = m->piece->degree;
    const double *w = curve_coefficients(m->c, m->piece, d);
    double norm = 0;
    pullback *p = &m->plane;
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
    p->size = 0;
    for (int k = 0; k <= n; k++)
        p->size = larger(p->size, fabs(p->at[k]));
}

static int sign_beyond(double value, double error) {
    return value > error ? 1 : value < -error ? -1 : 0;
}

/* D = X - v W in two coordinates, exact up to `error` in each. */
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
    return sign_beyond(value, error);
}

/* The two coordinates that side_sign asks for. */
static int first_axis(const meeter *m, int drop) {
    return m->c->dimension == 2 ? 0 : (drop + 1) % 3;
}
static int second_axis(const meeter *m, int drop) {
    return m->c->dimension == 2 ? 1 : (drop + 2) % 3;
}

/* Whether the whole span is certainly beyond one side. */
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

/* The plane's pullback at s; its error is that of the coefficients and of de Casteljau's scheme. */
static int plane_sign(const meeter *m, double s, double *value) {
    int n = m->piece->degree;
    double row[CARRIER_DEGREE + 1];
    memcpy(row, m->plane.at, (size_t)(n + 1) * sizeof *row);
    for (int level = 1; level <= n; level++)
        for (int k = 0; k <= n - level; k++)
            row[k] += s * (row[k + 1] - row[k]);
    *value = row[0];
    return sign_beyond(row[0], SLACK * (m->plane.error + 5 * n * U * m->plane.size));
}

/* A guess at the root between two places of opposite sign: the Illinois method. */
static double guess_root(const meeter *m) {
    double low = 0, high = 1, at_low = m->plane.at[0], at_high = m->plane.at[m->piece->degree];
    double s = at_low / (at_low - at_high), value;
    int kept = 0;
    for (int step = 0; step < 24 && m->piece->degree > 1; step++) {
        if (plane_sign(m, s, &value) == 0)
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

/* A window around the one root, its ends certain; 0 if none is found. */
static int find_window(meet_window *out, const meeter *m) {
    const double *p = m->plane.at;
    int n = m->piece->degree, before = p[0] > 0 ? 1 : -1;
    double s = guess_root(m), value;
    double width = 0x1p-48 + 4 * m->plane.error / fabs(p[n] - p[0]);
    for (int attempt = 0; attempt < 8; attempt++, width *= 32) {
        out->low = s - width > 0 ? s - width : 0;
        out->high = s + width < 1 ? s + width : 1;
        if ((out->low == 0 || plane_sign(m, out->low, &value) == before) &&
            (out->high == 1 || plane_sign(m, out->high, &value) == -before))
            return 1;
    }
    return 0;
}

/* As sides_meet. */
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

/* The sides at the window of the plane's one root. */
static meeting judge_window(const meeter *m, const meet_window *w) {
    unsigned inside, all = (1u << m->c->dimension) - 1;
    if (!judge_sides(&inside, m, w))
        return MEET_NONE;
    return flip(FLIP_ROOT_INSIDE, inside == all) ? MEET_CROSSING : MEET_ASK;
}

/* What the signs of the plane's coefficients say. */
typedef struct signs {
    int first, last; /* of the coefficients 0 and n; 0: not certain */
    int one;         /* all have the sign `first` */
    int single;      /* they change once, whatever the one that may be uncertain is */
} signs;

static signs read_signs(const meeter *m) {
    int n = m->piece->degree;
    enum { FIRST_RUN, UNCERTAIN, LAST_RUN };
    int before = FIRST_RUN;
    signs s = {sign_beyond(m->plane.at[0], m->plane.error),
               sign_beyond(m->plane.at[n], m->plane.error), 1, 0};
    s.one = s.first != 0;
    s.single = s.first * s.last < 0;
    for (int k = 0; k <= n; k++) {
        int sign = sign_beyond(m->plane.at[k], m->plane.error);
        int here = sign == 0 ? UNCERTAIN : sign == s.first ? FIRST_RUN : LAST_RUN;
        s.one = s.one && sign == s.first;
        /* An uncertain coefficient among those of one sign could be of the other: three changes. */
        s.single = s.single && here >= before && !(here == UNCERTAIN && before == UNCERTAIN);
        before = here;
    }
    return s;
}

static meeter begin_meeter(const curve *c, const span *piece, const double *corner,
                           double corner_error) {
    meeter m = {.c = c, .piece = piece, .corner = corner, .corner_error = corner_error};
    m.shift = curve_shift(c, piece);
    if (c->dimension == 2)
        normal_plane(&m.normal, corner, corner_error);
    else
        normal_space(&m.normal, corner, corner_error);
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
    signs s = read_signs(&m);
    if (flip(FLIP_ONE_SIGN, s.one))
        return MEET_NONE;
    if (flip(FLIP_ONE_ROOT, s.single)) {
        out->enters = flip(FLIP_DIRECTION, s.first > 0);
        if (find_window(out, &m))
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
