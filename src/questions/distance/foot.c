/* Nearest places of segments and triangles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/distance/gap.h"

#include <math.h>
#include "questions/distance/time_search.h"

/* Squares with a smaller relative difference may be equal but for rounding. */
static const double TIE = 0x1p-48;

int stance_make(stance *out, const point_arc *of, double time) {
    int d = of->dimension;
    if (!window_make(&out->at, of, time, time))
        return 0;
    window_trajectory(out->c, &out->at);
    out->rigid = of->rigid;
    out->dimension = d;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3 && !of->rigid; j++)
            out->linear[3 * i + j] =
                i < d && j < d ? out->at.place[i * (d + 1) + j][0] / out->at.place[d * (d + 1)][0]
                               : i == j;
    return 1;
}

/* The corners in the space of query points, the point at the origin. */
static void see_corners(double y[3][3], const stance *s, const double *corner) {
    for (int c = 0; c < s->dimension; c++) {
        double x[3] = {0, 0, 0};
        for (int i = 0; i < s->dimension; i++)
            x[i] = corner[c * s->dimension + i] - s->c[i];
        for (int i = 0; i < 3; i++)
            y[c][i] = s->rigid ? x[i] : dot3(s->linear + 3 * i, x);
    }
}

/* The share of b in the place nearest to the origin of the segment from a to b. */
static double share_of_edge(const double *a, const double *b) {
    double e[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, square = dot3(e, e);
    double share = square > 0 ? -dot3(a, e) / square : 0;
    return share > 0 ? smaller(share, 1) : 0;
}

/* Set the corners' shares in the origin's foot and the triangle's normal; returns 0 if the foot is
 * not in the triangle's interior. */
static int shares_of_face(double *share, double *normal, double y[3][3]) {
    double a[3], b[3];
    for (int i = 0; i < 3; i++) {
        a[i] = y[1][i] - y[0][i];
        b[i] = y[2][i] - y[0][i];
    }
    cross3(normal, a, b);
    double square = dot3(normal, normal);
    for (int k = 0; k < 3; k++) {
        const double *p = y[(k + 1) % 3], *q = y[(k + 2) % 3];
        double cross[3];
        cross3(cross, p, q);
        share[k] = dot3(cross, normal) / square;
    }
    return share[0] > 0 && share[1] > 0 && share[2] > 0;
}

/* Make n orthogonal to e, twice, since the first time may leave rounding errors as large as the
 * result. */
static void clear_along(double *n, const double *e) {
    double square = dot3(e, e);
    for (int round = 0; round < 2 && square > 0; round++) {
        double along = dot3(n, e) / square;
        for (int i = 0; i < 3; i++)
            n[i] -= along * e[i];
    }
}

/* Signed distance from the origin of the plane with normal n that supports the corners. */
static double support(const double *n, double y[3][3], int count) {
    double most = -INFINITY;
    for (int c = 0; c < count; c++)
        most = larger(most, dot3(n, y[c]));
    return -most / sqrt(dot3(n, n));
}

/* Find the foot of one edge: set the share of b and the direction from the foot to the origin, and
 * return the squared distance. */
static double foot_of_edge(double *share, double *n, const double *a, const double *b) {
    double e[3], s = share_of_edge(a, b);
    for (int i = 0; i < 3; i++) {
        e[i] = b[i] - a[i];
        n[i] = -(a[i] + s * e[i]);
    }
    double square = dot3(n, n);
    if (s > 0 && s < 1)
        clear_along(n, e);
    *share = s;
    return square;
}

/* Find the nearest of the edges' feet, the corners' shares in it and the direction from it to the
 * origin. Feet near a corner are equally far in doubles: the one whose direction proves the greater
 * distance is taken. */
static void foot_of_edges(double *share, double *n, double y[3][3], int count) {
    double best = INFINITY;
    share[0] = 1; /* if no square is finite, the foot is corner 0 */
    share[1] = share[2] = 0;
    for (int k = 0; k < (count == 3 ? 3 : 1); k++) {
        double s, m[3], square = foot_of_edge(&s, m, y[k], y[(k + 1) % count]);
        if (!(square < best * (1 + TIE)) ||
            (square > best * (1 - TIE) && support(m, y, count) <= support(n, y, count)))
            continue;
        best = smaller(best, square);
        share[0] = share[1] = share[2] = 0;
        share[k] = 1 - s;
        share[(k + 1) % count] = s;
        for (int i = 0; i < 3; i++)
            n[i] = m[i];
    }
}

/* The covector A^T n, of size about 1. */
static void set_covector(double *m, const stance *s, const double *n) {
    double most = largest3(n), scale = most > 0 ? 1 / most : 0;
    scale = scale <= 0x1p600 ? scale : 0;
    for (int j = 0; j < 3; j++) {
        double sum = 0;
        for (int i = 0; i < 3 && !s->rigid; i++)
            sum += s->linear[3 * i + j] * n[i] * scale;
        m[j] = s->rigid ? n[j] * scale : sum;
    }
}

void foot_find(foot *out, const stance *s, const double *corner) {
    double y[3][3] = {{0}}, share[3] = {0}, n[3] = {0};
    int d = s->dimension;
    see_corners(y, s, corner);
    out->inner = d == 3 && shares_of_face(share, n, y);
    if (!out->inner)
        foot_of_edges(share, n, y, d);
    else if (dot3(n, y[0]) > 0)
        for (int i = 0; i < 3; i++)
            n[i] = -n[i];
    if (d == 2)
        out->inner = share[0] > 0 && share[1] > 0;
    double second = smaller(share[1], 1), third = smaller(share[2], 1 - second);
    for (int i = 0; i < 3; i++) {
        const double *v = corner + i;
        out->q[i] = i < d ? v[0] + second * (v[d] - v[0]) : 0;
        if (d == 3)
            out->q[i] += third * (v[2 * d] - v[0]);
    }
    set_covector(out->m, s, n);
}

double foot_of_box(double *g, const stance *s, const box *b) {
    for (int i = 0; i < 3; i++) {
        double near = smaller(larger(s->c[i], b->low[i]), b->high[i]);
        g[i] = s->c[i] - near;
    }
    return dot3(g, g);
}
