/* Measures wrong rows. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/compare/depth.h"

#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include <string.h>
#include "base/number/rational.h"
#include "base/number/rounding.h"
#include "decide/verdict/classify.h"
#include "questions/distance/diagonal.h"

/* The width of an enclosure, in diagonals. */
static const double DEPTH_WIDTH = 1e-10;

void depth_clear(depths *d) {
    for (size_t k = 0; k < d->count; k++)
        free(d->rows[k].point);
    for (int k = 0; k < 3; k++)
        errors_clear(&d->by[k]);
    free(d->unmeasured);
}

static int count_depth(depths *d, int pmc, ceiling size) {
    return errors_add(&d->by[pmc], (value_error){size, size.digits > 0, 0});
}

/* The larger size of two bounds. */
static ceiling size_of(fmpq_t low, fmpq_t high) {
    fmpq_abs(low, low);
    fmpq_abs(high, high);
    return ceiling_of(fmpq_cmp(low, high) > 0 ? low : high);
}

graze_status depth_take(depths *d, const table *golden, const table_row *row, int pmc) {
    graze_context *context = golden->in.context;
    fmpq_t low, high;
    fmpq_init(low);
    fmpq_init(high);
    d->wrong++;
    graze_status status = table_number(low, context, table_field(golden, row, COLUMN_SDF_LOW));
    if (!status)
        status = table_number(high, context, table_field(golden, row, COLUMN_SDF_HIGH));
    if (!status && !count_depth(d, pmc, size_of(low, high)))
        status = context_fail(context, GRAZE_ESYSTEM, "out of memory");
    fmpq_clear(low);
    fmpq_clear(high);
    return status;
}

/* Keep every other row, so that those kept stay evenly spread. */
static void thin(depths *d) {
    size_t left = 0;
    for (size_t k = 0; k < d->count; k++)
        if (k % 2)
            free(d->rows[k].point);
        else
            d->rows[left++] = d->rows[k];
    d->count = left;
    d->stride *= 2;
}

int depth_wait(depths *d, char *point, int pmc) {
    if (!point)
        return 0;
    d->stride += !d->stride;
    if (d->count == MOST_MEASURED && d->wrong % d->stride == 0)
        thin(d);
    if (d->wrong++ % d->stride == 0)
        d->rows[d->count++] = (deep_row){point, pmc};
    else
        free(point);
    return 1;
}

static graze_status enclose_deep(distance *out, graze_context *context, const graze_scene *scene,
                                 const fmpq *point) {
    graze_trace trace;
    double diagonal;
    graze_status status = distance_diagonal(&diagonal, context, scene);
    if (!status)
        status = classify_point(&trace, context, scene, (query_point){.rational = point},
                                TRACE_CONTACTS);
    if (status)
        return status;
    status = distance_find(out, context, scene, point, &trace, DEPTH_WIDTH * diagonal);
    trace_clear(&trace);
    return status;
}

static graze_status take_bounds(depth_bounds *out, graze_context *context, const distance *found) {
    fmpq_t low, high;
    fmpq_init(low);
    fmpq_init(high);
    graze_status status = rational_from_double(low, context, found->low);
    if (!status)
        status = rational_from_double(high, context, found->high);
    report_bound(out->low, found->low, 0);
    report_bound(out->high, found->high, 1);
    out->size = size_of(low, high);
    fmpq_clear(low);
    fmpq_clear(high);
    return status;
}

graze_status depth_enclose(depth_bounds *out, graze_context *context, const graze_scene *scene,
                           const char *point) {
    slong d = scene->motion->dimension;
    fmpq *at = _fmpq_vec_init(d);
    distance found;
    graze_status status = GRAZE_OK;
    for (slong k = 0; k < d && !status; k++) {
        size_t length = strcspn(point, " ");
        status = rational_parse(at + k, context, point, length);
        point += length + (point[length] == ' ');
    }
    if (!status)
        status = enclose_deep(&found, context, scene, at);
    if (!status)
        status = take_bounds(out, context, &found);
    _fmpq_vec_clear(at, d);
    return status;
}

graze_status depth_measure(depths *d, graze_context *context, const graze_scene *scene) {
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < d->count && !status; k++) {
        depth_bounds found;
        status = depth_enclose(&found, context, scene, d->rows[k].point);
        if (!status && !count_depth(d, d->rows[k].pmc, found.size))
            status = context_fail(context, GRAZE_ESYSTEM, "out of memory");
    }
    return status;
}
