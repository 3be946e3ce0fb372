/* The exact trajectories of a point, made when they are needed, and its state at a time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/trace/trace.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"

static int dimension_of(const tracer *r) {
    return r->scene->motion->dimension;
}

static void set_homogeneous(fmpz *out, const tracer *r) {
    int d = dimension_of(r);
    if (r->point.rational) {
        _fmpq_vec_get_fmpz_vec_fmpz(out, out + d, r->point.rational, d);
        return;
    }
    LOCAL_VEC(fmpq, p, d);
    for (int k = 0; k < d; k++)
        (void)rational_from_double(p + k, r->context, r->point.value[k]); /* finite, by contract */
    _fmpq_vec_get_fmpz_vec_fmpz(out, out + d, p, d);
}

/* Make the point that trajectories carry, and room for them. */
static void begin_exact(tracer *r) {
    size_t n = r->scene->motion->piece_count;
    r->exact = malloc(n * sizeof *r->exact);
    r->is_exact = calloc(n, 1);
    r->homogeneous = _fmpz_vec_init(dimension_of(r) + 1);
    set_homogeneous(r->homogeneous, r);
}

const trajectory *tracer_exact(tracer *r, size_t piece) {
    if (!r->homogeneous)
        begin_exact(r);
    if (!r->exact || !r->is_exact) {
        (void)context_fail(r->context, GRAZE_ESYSTEM, "out of memory for %zu pieces of a motion",
                           r->scene->motion->piece_count);
        return NULL;
    }
    if (!r->is_exact[piece]) {
        const motion_piece *p = &r->scene->motion->piece[piece];
        const point_map *map = motion_tracing(p, r->scene->options.operation);
        trajectory_init(&r->exact[piece], dimension_of(r));
        trajectory_carry(&r->exact[piece], map, r->homogeneous);
        r->is_exact[piece] = 1;
    }
    return &r->exact[piece];
}

const span *tracer_quick(tracer *r, size_t piece) {
    if (!r->workspace || !filter_set(r->workspace, &r->scene->filter, &r->near))
        return NULL;
    const span *whole = curve_piece(&r->workspace->curve, piece);
    return whole && !whole->lost ? whole : NULL;
}

graze_status tracer_locate(graze_state *out, tracer *r, size_t piece, const fmpq_t u) {
    *out = GRAZE_STATE_ABSENT;
    if (r->workspace && fmpz_bits(fmpq_numref(u)) <= 53 && fmpz_bits(fmpq_denref(u)) <= 53) {
        /* u is dyadic, and so a double. */
        double at = fmpz_get_d(fmpq_numref(u)) / fmpz_get_d(fmpq_denref(u));
        *out = filter_locate(r->workspace, &r->scene->filter, piece, &r->near, at);
    }
    if (*out != GRAZE_STATE_ABSENT)
        return GRAZE_OK;
    const trajectory *c = tracer_exact(r, piece);
    if (!c)
        return GRAZE_ESYSTEM;
    LOCAL_VEC(fmpz, x, dimension_of(r) + 1);
    trajectory_at(x, c, u);
    *out = solid_locate(r->scene->solid, x);
    if (*out != GRAZE_STATE_I && *out != GRAZE_STATE_O)
        return context_fail(
            r->context, GRAZE_EINTERNAL,
            "the point between two contacts of a trace is neither inside nor outside");
    return GRAZE_OK;
}

/* The nearest doubles, or nearly so: conversion and division each lose less than 2^-51. From about
 * 2^1000 on they are infinite, which the filter refuses; below about 2^-1000 they are 0. */
static void approximate_point(filter_point *out, query_point point, int dimension) {
    for (int k = 0; k < dimension; k++) {
        if (point.value) {
            out->at[k] = point.value[k];
            continue;
        }
        slong top, bottom;
        double m = fmpz_get_d_2exp(&top, fmpq_numref(point.rational + k)) /
                   fmpz_get_d_2exp(&bottom, fmpq_denref(point.rational + k));
        slong e = top - bottom;
        out->at[k] = e > 1000 ? INFINITY : e < -1000 ? 0 : ldexp(m, (int)e);
    }
}

void tracer_begin(tracer *r) {
    if (r->context->exact_only)
        return;
    r->workspace = filter_workspace_of(r->context);
    if (r->workspace) {
        filter_begin(r->workspace);
        approximate_point(&r->near, r->point, dimension_of(r));
    }
}

void tracer_clear(tracer *r) {
    for (size_t k = 0; r->exact && r->is_exact && k < r->scene->motion->piece_count; k++)
        if (r->is_exact[k])
            trajectory_clear(&r->exact[k]);
    r->context->exact_count += r->exact != NULL;
    if (r->homogeneous)
        _fmpz_vec_clear(r->homogeneous, dimension_of(r) + 1);
    free(r->exact);
    free(r->is_exact);
    free(r->list.item);
}
