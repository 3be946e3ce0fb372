/* Bounds from Bernstein coefficients, whose products are binomial means.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/distance/gap.h"

#include <math.h>

#define U UNIT_ROUNDING
#define SLACK FILTER_SLACK
#define FLOOR FILTER_FLOOR

/* `half` has C(n, k), `whole` C(2n, k). */
typedef struct binomials {
    double half[SQUARE_ROOM], whole[SQUARE_ROOM];
} binomials;

static void fill_binomials(double *out, int n) {
    out[0] = 1;
    for (int k = 1; k <= n; k++)
        out[k] = out[k - 1] * (n + 1 - k) / k;
}

/* Set the binomials for degree n, and the 2n + 1 coefficients of a product to zero. */
static void begin_product(binomials *b, double *out, int n) {
    fill_binomials(b->half, n);
    fill_binomials(b->whole, 2 * n);
    for (int m = 0; m <= 2 * n; m++)
        out[m] = 0;
}

static double binomial_share(const binomials *b, int k, int l) {
    return b->half[k] * b->half[l] / b->whole[k + l];
}

void square_numbers(double *out, const double *c, int n) {
    binomials b;
    begin_product(&b, out, n);
    for (int k = 0; k <= n; k++)
        for (int l = 0; l <= n; l++)
            out[k + l] += binomial_share(&b, k, l) * c[k] * c[l];
}

void product_vectors(double *out, const double (*a)[3], const double (*c)[3], int n) {
    binomials b;
    begin_product(&b, out, n);
    for (int k = 0; k <= n; k++)
        for (int l = 0; l <= n; l++)
            out[k + l] += binomial_share(&b, k, l) * dot3(a[k], c[l]);
}

void square_vectors(double *out, const double (*c)[3], int n) {
    product_vectors(out, c, c, n);
}

/* A vector function of degree n over a weight: coordinate i of coefficient k at at[k][i]. */
typedef struct gap {
    int degree;
    double at[WINDOW_ROOM + 1][3], weight[WINDOW_ROOM + 1];
    double stray, least, most_w; /* error of a coordinate of `at`; lower bound of the weight; error
                                    of a coefficient of the weight */
} gap;

/* Set the gap on a rigid piece, in the solid's space: the vector from place q to the trajectory,
 * times W. */
static void gap_rigid(gap *out, const window *w, const double *q) {
    int d = w->of->dimension;
    out->degree = w->degree;
    out->stray = w->stray;
    out->least = w->least;
    out->most_w = w->most_w;
    for (int k = 0; k <= w->degree; k++) {
        out->weight[k] = w->x[d][k];
        for (int i = 0; i < 3; i++)
            out->at[k][i] = i < d ? w->x[i][k] - q[i] * w->x[d][k] : 0;
    }
}

/* Set the gap on a piece that is not rigid, in the space of query points: the vector from place q
 * to the query point, times the weight. */
static void gap_placed(gap *out, const window *w, const double *q) {
    int d = w->of->dimension;
    const double *weight = w->place[d * (d + 1)];
    out->degree = w->place_degree;
    out->stray = w->place_stray;
    out->least = w->place_least;
    out->most_w = w->place_most_w;
    for (int k = 0; k <= w->place_degree; k++) {
        out->weight[k] = weight[k];
        out->at[k][2] = 0;
        for (int i = 0; i < d; i++) {
            double sum = w->of->point[i] * weight[k] - w->place[i * (d + 1) + d][k];
            for (int j = 0; j < d; j++)
                sum -= w->place[i * (d + 1) + j][k] * q[j];
            out->at[k][i] = sum;
        }
    }
}

static void gap_at(gap *out, const window *w, const double *q) {
    if (w->of->rigid)
        gap_rigid(out, w, q);
    else
        gap_placed(out, w, q);
}

/* Combine the gaps of the places q0 and q1 into the gap of the place that moves from q0 to q1, one
 * degree higher. */
static void gap_join(gap *first, const gap *last) {
    int n = first->degree;
    for (int k = n + 1; k >= 0; k--) {
        double a = k <= n ? (double)(n + 1 - k) / (n + 1) : 0, b = (double)k / (n + 1);
        for (int i = 0; i < 3; i++)
            first->at[k][i] =
                (k <= n ? a * first->at[k][i] : 0) + (k > 0 ? b * last->at[k - 1][i] : 0);
        first->weight[k] =
            (k <= n ? a * first->weight[k] : 0) + (k > 0 ? b * last->weight[k - 1] : 0);
    }
    first->degree = n + 1;
}

/* The greatest |at| of the control points. */
static double greatest(const gap *g) {
    double most = 0;
    for (int k = 0; k <= g->degree; k++)
        most = larger(most, dot3(g->at[k], g->at[k]));
    return sqrt(most) * ROUNDED_UP;
}

/* 1 plus a bound of the relative error of a quotient, from errors of the weight and roundings of
 * means. */
static double weight_slack(const gap *g) {
    double most = 0;
    for (int k = 0; k <= g->degree; k++)
        most = larger(most, g->weight[k]);
    return 1 + SLACK * (g->most_w + (48 + 12 * g->degree) * U * most) / g->least;
}

double gap_most(const window *w, const double *q0, const double *q1) {
    gap g, last;
    double squares[SQUARE_ROOM], weights[SQUARE_ROOM], out = 0, control = 0;
    gap_at(&g, w, q0);
    if (w->from < w->to) {
        gap_at(&last, w, q1);
        gap_join(&g, &last);
    }
    double slack = weight_slack(&g), stray = 2 * g.stray / g.least;
    for (int k = 0; k <= g.degree; k++)
        control = larger(control, sqrt(dot3(g.at[k], g.at[k]) + FLOOR) / g.weight[k]);
    if (g.degree > 0 && g.degree <= SQUARED + 1) {
        double size = greatest(&g), error = SQUARE_ERROR * size * size + FLOOR;
        square_vectors(squares, (const double(*)[3])g.at, g.degree);
        square_numbers(weights, g.weight, g.degree);
        for (int m = 0; m <= 2 * g.degree; m++)
            out = larger(out, (squares[m] + error) / weights[m]);
        control = smaller(control, sqrt(out));
    }
    out = (control * slack + stray) * ROUNDED_UP;
    return out >= 0 ? out : INFINITY;
}

/* The vector from a corner to the place q in the space of the gap, times the weight; its degree is
 * that of gap_at. */
static void lever(gap *out, const window *w, const double *q, const double *corner) {
    int d = w->of->dimension;
    double edge[3] = {0, 0, 0};
    for (int i = 0; i < d; i++)
        edge[i] = q[i] - corner[i];
    out->degree = w->of->rigid ? w->degree : w->place_degree;
    for (int k = 0; k <= out->degree; k++)
        for (int i = 0; i < 3; i++) {
            double sum = 0;
            for (int j = 0; j < d && i < d && !w->of->rigid; j++)
                sum += w->place[i * (d + 1) + j][k] * edge[j];
            out->at[k][i] = w->of->rigid ? edge[i] * w->x[d][k] : sum;
            out->weight[k] = 0;
        }
}

/* squares += 2 min(0, at . lever over all corners), coefficient by coefficient; returns the
 * greatest length of a lever. */
static double add_levers(double *squares, const window *w, const gap *g, const double *q0,
                         const double *q1, const double *corner, int count) {
    double worst[SQUARE_ROOM] = {0}, product[SQUARE_ROOM], longest = 0;
    for (int c = 0; c < count; c++) {
        gap first, last;
        lever(&first, w, q0, corner + c * w->of->dimension);
        lever(&last, w, q1, corner + c * w->of->dimension);
        gap_join(&first, &last);
        longest = larger(longest, greatest(&first));
        product_vectors(product, (const double(*)[3])g->at, (const double(*)[3])first.at,
                        g->degree);
        for (int m = 0; m <= 2 * g->degree; m++)
            worst[m] = smaller(worst[m], product[m]);
    }
    for (int m = 0; m <= 2 * g->degree; m++)
        squares[m] += 2 * worst[m];
    return longest;
}

double gap_about(const window *w, const double *q0, const double *q1, const double *corner,
                 int count) {
    gap g, last;
    double squares[SQUARE_ROOM], weights[SQUARE_ROOM], least = INFINITY;
    gap_at(&g, w, q0);
    gap_at(&last, w, q1);
    if (g.degree >= SQUARED)
        return 0;
    gap_join(&g, &last);
    square_vectors(squares, (const double(*)[3])g.at, g.degree);
    square_numbers(weights, g.weight, g.degree);
    double size = greatest(&g), stray = 2 * g.stray;
    double lever_size = add_levers(squares, w, &g, q0, q1, corner, count);
    double error = SLACK * (2 * size * stray + stray * stray +
                            2 * (stray * lever_size + 2 * size * stray + 2 * stray * stray) +
                            SQUARE_ERROR * size * (size + 2 * lever_size)) +
                   FLOOR;
    for (int m = 0; m <= 2 * g.degree; m++)
        least = smaller(least, (squares[m] - error) / weights[m]);
    return least > 0 ? sqrt(least) / weight_slack(&g) * ROUNDED_DOWN : 0;
}
