/* Spans: coefficients by halving, errors by level, a thick chord as bound.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The bounds are derived in proofs/filter.md (C32, C33). Every operation rounds to
 * nearest; U is the unit of rounding.
 */
#include "decide/bounds/bounds.h"

#include <math.h>
#include <stdlib.h>
#include "base/context/array.h"

#define U UNIT_ROUNDING
#define SLACK FILTER_SLACK
#define FLOOR FILTER_FLOOR

/* A curve that needs more spans than these is left to the exact path. */
enum { MOST_SPANS = 8192, SPANS_A_PIECE = 64 };

void curve_init(curve *c) {
    *c = (curve){.dimension = 0};
}

void curve_clear(curve *c) {
    free(c->spans);
    free(c->coefficients);
    curve_init(c);
}

const double *curve_coefficients(const curve *c, const span *piece, int i) {
    return c->coefficients + (size_t)(piece - c->spans) * c->stride + i * (piece->degree + 1);
}

/* Room for two more spans; 0 if there is no memory. */
static int reserve_halves(curve *c) {
    size_t count = c->count + 2;
    if (!array_reserve(&c->spans, &c->capacity, count, sizeof *c->spans) ||
        !array_reserve(&c->coefficients, &c->room, count * c->stride, sizeof *c->coefficients))
        c->out_of_memory = 1;
    return !c->out_of_memory;
}

/* Bound D = X - v W and its derivative by the coefficients and their errors. */
shift_bound curve_shift(const curve *c, const span *piece) {
    int d = c->dimension, n = piece->degree;
    double error = 0, size = 0, steepest = 0;
    for (int i = 0; i <= d; i++) {
        const double *x = curve_coefficients(c, piece, i);
        double step = 0;
        for (int k = 0; k < n; k++)
            step = larger(step, fabs(x[k + 1] - x[k]));
        if (i < d) {
            error = larger(error, piece->error[i] + 2 * U * piece->size[i]);
            size = larger(size, piece->size[i]);
            steepest = larger(steepest, step + 2 * piece->error[i]);
        } else {
            error += (c->corners->reach + c->corners->error) * piece->error[d] +
                     (c->corners->error + 4 * U * c->corners->reach) * piece->size[d];
            size += c->corners->reach * piece->size[d];
            steepest += c->corners->reach * (step + 2 * piece->error[d]);
        }
    }
    return (shift_bound){SLACK * error, SLACK * (size + error),
                         SLACK * n * (steepest + 2 * U * size)};
}

/* Set `end`, `far` and `wide`, the bounds for linear forms (proofs/filter.md C35 (f)). */
static void bound_forms(span *piece, const curve *c) {
    double size = 0, thick = 0, off = c->corners->error;
    for (int i = 0; i < 3; i++) {
        piece->end[i] = piece->from[i] + piece->along[i];
        size = larger(size, larger(fabs(piece->from[i]), fabs(piece->end[i])));
        thick = larger(thick, piece->thick[i]);
    }
    piece->far = SLACK * (c->corners->reach + off + size + thick);
    for (int i = 0; i < 3; i++)
        piece->wide[i] = SLACK * (piece->thick[i] + off + 16 * U * piece->far);
}

/* Set the chord and its thickness: the distances of the control points X_k / W_k from the chord's
 * points at k / n bound that of the curve. */
static void bound_space(span *piece, const curve *c) {
    int d = c->dimension, n = piece->degree;
    const double *w = curve_coefficients(c, piece, d);
    double least = w[0], each = 1.0 / n, share[CARRIER_DEGREE + 1];
    double inverse[CARRIER_DEGREE + 1];
    inverse[0] = 1 / w[0];
    for (int k = 1; k <= n; k++) {
        least = smaller(least, w[k]);
        inverse[k] = 1 / w[k];
        share[k] = k * each;
    }
    piece->bounded = flip(FLIP_WEIGHT, least > 2 * piece->error[d]);
    piece->bend = 0;
    for (int i = 0; i < 3; i++)
        piece->from[i] = piece->along[i] = piece->thick[i] = piece->inverse[i] = 0;
    for (int i = 0; i < d && piece->bounded; i++) {
        const double *x = curve_coefficients(c, piece, i);
        double from = x[0] * inverse[0], along = x[n] * inverse[n] - from, off = 0;
        double most = fabs(from);
        for (int k = 1; k <= n; k++) {
            double at = x[k] * inverse[k];
            off = larger(off, fabs(at - (from + along * share[k])));
            most = larger(most, fabs(at));
        }
        piece->from[i] = from;
        piece->along[i] = along;
        piece->thick[i] =
            SLACK * (off + 2 * (piece->error[i] + most * piece->error[d]) / least + 16 * U * most);
        piece->thick[i] += 16 * U * (c->corners->axis_reach[i] + most + piece->thick[i]);
        /* A smaller `off` is mostly rounding, which no cut makes smaller. */
        if (off > 0.5 * piece->thick[i])
            piece->bend = larger(piece->bend, off);
    }
    for (int i = 0; i < 3; i++)
        piece->inverse[i] = 1 / piece->along[i];
    bound_forms(piece, c);
}

/* Set errors and bounds of a span whose coefficients and other fields are set; it is not cut. */
static void finish_span(curve *c, size_t index, const double *error) {
    span *piece = &c->spans[index];
    piece->child = 0;
    for (int i = 0; i <= c->dimension; i++)
        piece->error[i] = error[i];
    bound_space(piece, c);
}

/* Set sizes, errors and bounds of the span of a whole piece whose coefficients are set. */
static void finish_whole(curve *c, size_t index, const double *error) {
    span *piece = &c->spans[index];
    double largest = 0;
    for (int i = 0; i <= c->dimension; i++) {
        const double *x = curve_coefficients(c, piece, i);
        piece->size[i] = 0;
        for (int k = 0; k <= piece->degree; k++)
            piece->size[i] = larger(piece->size[i], fabs(x[k]));
        piece->size[i] += error[i];
        largest = larger(largest, piece->size[i]);
    }
    finish_span(c, index, error);
    piece->lost = !(largest <= 0x1p410);
}

static void set_piece(curve *c, size_t index, const carrier *map) {
    int d = map->dimension, n = map->degree;
    double error[4], *to = c->coefficients + index * c->stride;
    c->spans[index].degree = n;
    c->spans[index].lost = !map->usable;
    if (!map->usable)
        return;
    for (int i = 0; i < d; i++) {
        double most = 0, *x = to + i * (n + 1);
        for (int k = 0; k <= n; k++) {
            const double *entry = map->entry + i * (d + 1) * (n + 1) + k;
            double sum = entry[d * (n + 1)], size = fabs(sum);
            for (int j = 0; j < d; j++) {
                double term = entry[j * (n + 1)] * c->point.at[j];
                sum += term;
                size += fabs(term);
            }
            x[k] = sum;
            most = larger(most, size);
        }
        error[i] = 20 * U * most + FLOOR;
    }
    for (int k = 0; k <= n; k++)
        to[d * (n + 1) + k] = map->weight[k];
    error[d] = 4 * U + FLOOR;
    finish_whole(c, index, error);
}

/* Set the chord of several pieces, so thick that it holds the images of the point by all means of
 * their matrices (proofs/filter.md C34).
 */
static void bound_several(span *whole, const curve *c, const piece_group *g) {
    int d = c->dimension;
    for (int i = 0; i < d; i++) {
        const double *first = g->first + i * (d + 1), *last = g->last + i * (d + 1);
        const double *off = g->off + i * (d + 1);
        double from = first[d], to = last[d], stray = off[d];
        double size = fabs(from) + fabs(to) + stray;
        for (int j = 0; j < d; j++) {
            double p = c->point.at[j];
            from += first[j] * p;
            to += last[j] * p;
            stray += off[j] * fabs(p);
            size += (fabs(first[j]) + fabs(last[j]) + off[j]) * fabs(p);
        }
        double most = larger(fabs(from), fabs(to)),
               thick = SLACK * (stray + 0x1p-46 * size) + FLOOR;
        whole->from[i] = from;
        whole->along[i] = to - from;
        whole->thick[i] = thick + 16 * U * (c->corners->axis_reach[i] + most + thick);
        whole->bend = larger(whole->bend, whole->thick[i]);
    }
    for (int i = 0; i < 3; i++)
        whole->inverse[i] = 1 / whole->along[i];
    bound_forms(whole, c);
}

/* Make a span of a group of the course: of one piece, or of several. */
static void set_group(curve *c, size_t index, uint32_t group) {
    const piece_group *g = &c->course->group[group];
    c->spans[index] = (span){.piece = g->piece, .group = group};
    if (!g->child) {
        set_piece(c, index, &c->course->piece[g->piece]);
    } else if (flip(FLIP_GROUP, g->bounded)) {
        c->spans[index].bounded = 1;
        bound_several(&c->spans[index], c, g);
    }
}

static int begin_curve(curve *c, int dimension, int degree, const corners *corners) {
    c->dimension = dimension;
    c->corners = corners;
    c->stride = (size_t)(dimension + 1) * (size_t)(degree + 1);
    c->count = 0;
    return reserve_halves(c);
}

int curve_set(curve *c, const course *course, const filter_point *point, const corners *corners) {
    if (!begin_curve(c, course->dimension, course->degree, corners))
        return 0;
    for (int j = 0; j < course->dimension; j++)
        if (!(fabs(point->at[j]) <= CARRIER_REACH))
            return 0;
    c->course = course;
    c->point = *point;
    c->count = 1;
    set_group(c, 0, 0);
    return 1;
}

int curve_set_segment(curve *c, int dimension, const double *at, const double *error,
                      const double *direction, const corners *corners) {
    double e[4];
    if (!begin_curve(c, dimension, 1, corners))
        return 0;
    c->course = NULL;
    c->count = 1;
    c->spans[0] = (span){.degree = 1};
    for (int i = 0; i <= dimension; i++) {
        double *x = c->coefficients + 2 * i;
        x[0] = at[i];
        x[1] = i < dimension ? at[i] + direction[i] * at[dimension] : at[i];
        e[i] = error[i] + FLOOR;
    }
    /* The rounding of the far end only turns the ray a little, and any direction serves. */
    finish_whole(c, 0, e);
    return !c->spans[0].lost;
}

static void cut_piece(curve *c, const span *whole, uint32_t child) {
    int n = whole->degree;
    double error[4];
    for (int i = 0; i <= c->dimension; i++) {
        pullback_halve(c->coefficients + child * c->stride + (size_t)(i * (n + 1)),
                       c->coefficients + (child + 1) * c->stride + (size_t)(i * (n + 1)),
                       curve_coefficients(c, whole, i), n);
        error[i] = whole->error[i] + (n + 1) * U * whole->size[i];
    }
    for (uint32_t half = 0; half < 2; half++) {
        span *piece = &c->spans[child + half];
        *piece = *whole;
        piece->level = whole->level + 1;
        piece->start = whole->start + half * (UINT32_C(1) << (WINDOW_LEVELS - piece->level));
        finish_span(c, child + half, error);
    }
}

int curve_cut(curve *c, uint32_t index) {
    size_t most = MOST_SPANS + (c->course ? SPANS_A_PIECE * c->course->piece_count : 0);
    if (c->spans[index].child)
        return 1;
    if (c->count > most || !reserve_halves(c))
        return 0;
    uint32_t child = (uint32_t)c->count;
    const span *whole = &c->spans[index];
    c->count += 2;
    if (whole->degree) {
        cut_piece(c, whole, child);
    } else {
        uint32_t group = c->course->group[whole->group].child;
        set_group(c, child, group);
        set_group(c, child + 1, group + 1);
    }
    c->spans[index].child = child;
    return 1;
}

const span *curve_piece(curve *c, size_t piece) {
    uint32_t at = 0;
    while (c->spans[at].degree == 0 && !c->spans[at].lost) {
        if (!curve_cut(c, at))
            return NULL;
        uint32_t half = c->spans[at].child;
        at = piece < c->spans[half + 1].piece ? half : half + 1;
    }
    return &c->spans[at];
}

double curve_blossom(const double *c, int n, int k, double from, double to) {
    double b[CARRIER_DEGREE + 1];
    b[0] = c[0];
    for (int i = 1; i <= n; i++)
        b[i] = c[i];
    for (int level = 1; level <= n; level++) {
        double s = level <= k ? to : from;
        for (int i = 0; i <= n - level; i++)
            b[i] += s * (b[i + 1] - b[i]);
    }
    return b[0];
}

void curve_at(double *at, double *error, const curve *c, const span *piece, double s) {
    int n = piece->degree;
    for (int i = 0; i <= c->dimension; i++) {
        at[i] = curve_blossom(curve_coefficients(c, piece, i), n, n, s, s);
        error[i] = SLACK * (piece->error[i] + 5 * n * U * piece->size[i]);
    }
}

int place_bound(box *out, const double *place, const double *off, int dimension) {
    double least = place[dimension] - off[dimension], most = place[dimension] + off[dimension];
    *out = (box){{0, 0, 0}, {0, 0, 0}};
    if (!(least > 0.5 * place[dimension]))
        return 0;
    for (int i = 0; i < dimension; i++) {
        double low = place[i] - off[i], high = place[i] + off[i];
        out->low[i] = low / (low < 0 ? least : most);
        out->high[i] = high / (high < 0 ? most : least);
        double margin = 0x1p-48 * (fabs(out->low[i]) + fabs(out->high[i])) + FILTER_FLOOR;
        out->low[i] -= margin;
        out->high[i] += margin;
    }
    return 1;
}

void span_of_box(span *out, const curve *shape, const box *b) {
    *out = (span){.bounded = 1};
    for (int i = 0; i < shape->dimension; i++) {
        double middle = 0.5 * (b->low[i] + b->high[i]);
        out->from[i] = middle;
        out->thick[i] = SLACK * larger(b->high[i] - middle, middle - b->low[i]) + FLOOR;
    }
    bound_forms(out, shape);
}

int span_meets(const span *piece, const box *b) {
    double first, last;
    return span_window(&first, &last, piece, b);
}

int span_window(double *from, double *to, const span *piece, const box *b) {
    double first = 0, last = 1;
    if (!piece->bounded) {
        *from = 0;
        *to = 1;
        return 1;
    }
    for (int i = 0; i < 3; i++) {
        double t0 = (b->low[i] - piece->thick[i] - piece->from[i]) * piece->inverse[i];
        double t1 = (b->high[i] + piece->thick[i] - piece->from[i]) * piece->inverse[i];
        double enter = t0 < t1 ? t0 : t1, leave = t0 < t1 ? t1 : t0;
        /* A comparison with NaN, which 0 times infinity gives, leaves nothing out. */
        first = enter > first ? enter : first;
        last = leave < last ? leave : last;
    }
    *from = first;
    *to = last;
    return !(first > last);
}
