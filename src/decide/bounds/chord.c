/* A thick chord against the plane of a simplex, then against its sides where it can be in the
 * plane. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The set { from + s along + r : s in [0, 1], |r_i| <= thick_i } holds the span, and forms are
 * linear in s: their values at two places bound those between the two. The error bounds are those
 * of proofs/filter.md (C35, C36). A comparison that is false for NaN never decides.
 */
#include "decide/bounds/bounds.h"

#include <math.h>

/* The thick chord can be in the plane only where s is in [low, high]. `through`: its ends are
 * certain to lie on different sides of the plane. */
typedef struct chord_window {
    double low, high;
    int through;
} chord_window;

/* Find the part of the thick chord that can be in the plane; 0 if the chord is certainly on one
 * side of the plane. */
static inline int reach_plane(chord_window *out, const span *piece, const double *corner,
                              const normal *n, int d) {
    double first = 0, last = 0, wide = 0;
    for (int i = 0; i < d; i++) {
        first += n->at[i] * (piece->from[i] - corner[i]);
        last += n->at[i] * (piece->end[i] - corner[i]);
        wide += fabs(n->at[i]) * piece->wide[i];
    }
    double bound = FILTER_SLACK * (wide + 3 * n->error * piece->far) + FILTER_FLOOR;
    if (flip(FLIP_CHORD_PLANE,
             (first > bound && last > bound) || (first < -bound && last < -bound)))
        return 0;
    double step = first - last, half = FILTER_SLACK * (bound / fabs(step)) + 0x1p-48;
    double middle = first / step;
    *out = (chord_window){0, 1, 0};
    if (half < 2) {
        out->low = smaller(larger(middle - half, 0), 1);
        out->high = smaller(larger(middle + half, 0), 1);
        out->through = fabs(first) > bound && fabs(last) > bound;
    }
    return 1;
}

/* The chord's place at s. */
static inline void chord_place(double *at, const span *piece, double s, int d) {
    for (int i = 0; i < d; i++)
        at[i] = piece->from[i] + s * piece->along[i];
}

/* The sign that the form of a side has on the whole window, by its values at both ends; 0 if it has
 * both signs, or no certain one. */
static inline int side_beyond(double first, double last, double bound) {
    return first > bound && last > bound ? 1 : first < -bound && last < -bound ? -1 : 0;
}

static inline chord_meeting pass_sides_space(const span *piece, const double *corner, double blur,
                                             const normal *n, const chord_window *window) {
    int drop = normal_axis(n, 3), inside = 1;
    if (drop < 0)
        return CHORD_NEAR;
    int i = (drop + 1) % 3, j = (drop + 2) % 3;
    double low[3], high[3], facing = n->at[drop] > 0 ? 1 : -1;
    chord_place(low, piece, window->low, 3);
    chord_place(high, piece, window->high, 3);
    for (int k = 0; k < 3; k++) {
        const double *v = corner + 3 * k, *next = corner + 3 * (k < 2 ? k + 1 : 0);
        double ei = facing * (next[i] - v[i]), ej = facing * (next[j] - v[j]);
        double first = ei * (low[j] - v[j]) - ej * (low[i] - v[i]);
        double last = ei * (high[j] - v[j]) - ej * (high[i] - v[i]);
        double bound =
            FILTER_SLACK * (fabs(ei) * piece->wide[j] + fabs(ej) * piece->wide[i] + blur) +
            FILTER_FLOOR;
        int side = side_beyond(first, last, bound);
        if (flip(FLIP_CHORD_BESIDE, side < 0))
            return CHORD_MISSES;
        inside = inside && side > 0;
    }
    return inside && window->through ? CHORD_PIERCES : CHORD_NEAR;
}

static inline chord_meeting pass_sides_plane(const span *piece, const double *corner, double blur,
                                             const chord_window *window) {
    int inside = 1;
    double low[2], high[2];
    double ei = corner[2] - corner[0], ej = corner[3] - corner[1];
    double bound = FILTER_SLACK * (fabs(ei) * piece->wide[0] + fabs(ej) * piece->wide[1] + blur) +
                   FILTER_FLOOR;
    chord_place(low, piece, window->low, 2);
    chord_place(high, piece, window->high, 2);
    for (int k = 0; k < 2; k++) {
        const double *v = corner + 2 * k;
        double first = ei * (low[0] - v[0]) + ej * (low[1] - v[1]);
        double last = ei * (high[0] - v[0]) + ej * (high[1] - v[1]);
        int side = k == 0 ? side_beyond(first, last, bound) : -side_beyond(first, last, bound);
        if (flip(FLIP_CHORD_BESIDE, side < 0))
            return CHORD_MISSES;
        inside = inside && side > 0;
    }
    return inside && window->through ? CHORD_PIERCES : CHORD_NEAR;
}

chord_meeting chord_meets(const curve *c, const span *piece, const double *corner,
                          double corner_error) {
    normal n;
    chord_window window;
    double blur = 4 * corner_error * piece->far;
    if (!piece->bounded)
        return CHORD_NEAR;
    if (c->dimension == 2) {
        normal_plane(&n, corner, corner_error);
        return reach_plane(&window, piece, corner, &n, 2)
                   ? pass_sides_plane(piece, corner, blur, &window)
                   : CHORD_MISSES;
    }
    normal_space(&n, corner, corner_error);
    return reach_plane(&window, piece, corner, &n, 3)
               ? pass_sides_space(piece, corner, blur, &n, &window)
               : CHORD_MISSES;
}
