/* Windows by blossoms of the whole arc's coefficients, so that errors do not grow with depth.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/distance/gap.h"

#include <math.h>

#define U UNIT_ROUNDING

/* Set the coefficients on [from, to]; for an instant, from = to, only one, the value. */
static void restrict_to(double *out, const double *c, int n, double from, double to) {
    int most = from < to ? n : 0;
    for (int k = 0; k <= most; k++)
        out[k] = curve_blossom(c, n, k, from, to);
}

static double largest_size(const double *c, int n) {
    double most = 0;
    for (int k = 0; k <= n; k++)
        most = larger(most, fabs(c[k]));
    return most;
}

graze_status point_arc_make(point_arc *out, graze_context *context, const arc_maps *base,
                            size_t index, const double *low, const double *high) {
    const carrier *map = arc_maps_tracing(base, index);
    int d = map->dimension, n = map->degree;
    out->base = base;
    out->arc = index;
    out->dimension = d;
    out->degree = n;
    out->rigid = base->arc[index].rigid;
    out->error_x = out->size_x = out->point_error = 0;
    for (int j = 0; j < d; j++) {
        out->point[j] = low[j];
        out->point_error = larger(out->point_error, high[j] - low[j]);
        if (!(fabs(low[j]) <= CARRIER_REACH && fabs(high[j]) <= CARRIER_REACH))
            return context_fail(context, GRAZE_ELIMIT,
                                "coordinate %d of the point is too large for a distance; expected "
                                "at most 2^200",
                                j);
    }
    double most = 0,
           off = 0; /* no sum overflows: entries and coordinates are at most CARRIER_REACH */
    for (int i = 0; i < d; i++)
        for (int k = 0; k <= n; k++) {
            const double *entry = map->entry + i * (d + 1) * (n + 1) + k;
            double sum = entry[d * (n + 1)], size = fabs(sum), step = 0;
            for (int j = 0; j < d; j++) {
                sum += entry[j * (n + 1)] * low[j];
                size += fabs(entry[j * (n + 1)] * low[j]);
                step += fabs(entry[j * (n + 1)]) * (high[j] - low[j]);
            }
            out->x[i][k] = sum;
            most = larger(most, size);
            off = larger(off, step);
        }
    out->error_x = FILTER_SLACK * (20 * U * most + off) + FILTER_FLOOR;
    out->size_x = most;
    for (int k = 0; k <= n; k++)
        out->x[d][k] = map->weight[k];
    out->size_w = largest_size(map->weight, n);
    out->error_w = 4 * U + FILTER_FLOOR;
    return GRAZE_OK;
}

/* Restrict the linear part of the tracing map, and bound its error. */
static void restrict_linear(window *w) {
    const point_arc *p = w->of;
    const carrier *map = arc_maps_tracing(p->base, p->arc);
    int d = p->dimension, n = map->degree;
    double most = 0;
    for (int i = 0; i < d; i++)
        for (int j = 0; j < d; j++) {
            const double *entry = map->entry + (i * (d + 1) + j) * (n + 1);
            restrict_to(w->linear[i * d + j], entry, n, w->from, w->to);
            most = larger(most, largest_size(entry, n));
        }
    w->linear_stray = FILTER_SLACK * (8 + 5 * n) * U * most + FILTER_FLOOR;
}

/* Restrict the placing map, and bound its errors and its weight. */
static void restrict_place(window *w) {
    const point_arc *p = w->of;
    const carrier *map = &p->base->arc[p->arc].placing;
    const corners *corners = &p->base->scene->solid->corners;
    int d = p->dimension, n = map->degree, entries = d * (d + 1);
    double point = 0, matrix = 0, shift = 0, off = corners->error + 8 * U * corners->reach;
    for (int e = 0; e <= entries; e++) {
        restrict_to(w->place[e], map->entry + e * (n + 1), n, w->from, w->to);
        double *size = e < entries && e % (d + 1) == d ? &shift : &matrix;
        if (e < entries)
            *size = larger(*size, largest_size(map->entry + e * (n + 1), n));
    }
    for (int j = 0; j < d; j++)
        point = larger(point, fabs(p->point[j]));
    w->place_degree = w->from < w->to ? n : 0;
    double weight = largest_size(map->weight, n), step = (16 + 5 * n) * U;
    w->place_stray = FILTER_SLACK * (step * (weight * point + shift + d * matrix * corners->reach) +
                                     weight * p->point_error + d * matrix * off) +
                     FILTER_FLOOR;
    w->place_least = w->place[entries][0];
    for (int k = 1; k <= w->place_degree; k++)
        w->place_least = smaller(w->place_least, w->place[entries][k]);
    w->place_most_w = step * weight + FILTER_FLOOR;
    w->place_least -= w->place_most_w;
}

int window_make(window *out, const point_arc *of, double from, double to) {
    const corners *corners = &of->base->scene->solid->corners;
    int d = of->dimension, n = of->degree;
    out->of = of;
    out->from = from;
    out->to = to;
    out->degree = from < to ? n : 0;
    for (int i = 0; i <= d; i++)
        restrict_to(out->x[i], of->x[i], n, from, to);
    double error_w = FILTER_SLACK * (of->error_w + 5 * n * U * of->size_w);
    double reach = corners->reach, off = corners->error;
    out->most_w = error_w;
    out->stray = FILTER_SLACK * (of->error_x + (5 * n + 8) * U * of->size_x + reach * error_w +
                                 (2 * off + 16 * U * reach) * of->size_w) +
                 FILTER_FLOOR;
    out->least = out->x[d][0];
    for (int k = 1; k <= out->degree; k++)
        out->least = smaller(out->least, out->x[d][k]);
    out->least -= error_w;
    if (!of->rigid) {
        restrict_linear(out);
        restrict_place(out);
    }
    return out->least > 0x1p-60 && (of->rigid || out->place_least > 0x1p-60);
}

void window_trajectory(double *out, const window *w) {
    int d = w->of->dimension, k = w->degree / 2;
    for (int i = 0; i < 3; i++)
        out[i] = i < d ? w->x[i][k] / w->x[d][k] : 0;
}
