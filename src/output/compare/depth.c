/* Measures wrong rows. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/compare/compare.h"

#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "base/number/rounding.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"
#include "output/compare/counts.h"
#include "output/compare/rows.h"
#include "output/report/report.h"
#include "questions/distance/distance.h"

/* The width of an enclosure, in diagonals. */
static const double DEPTH_WIDTH = 1e-13;

const char *const depth_parts[DEPTH_PARTS] = {"1e-12", "1e-9", "1e-6", "1e-3"};

void depth_clear(depths *d) {
    for (int k = 0; k < 3; k++)
        errors_clear(&d->by[k]);
    fmpq_clear(d->size);
    free(d->unmeasured);
}

/* Count a row whose distance is at least `least` by the parts of the size that this is beyond. */
static void count_parts(depths *d, const fmpq_t least) {
    LOCAL(fmpq, scaled);
    fmpq_set(scaled, least);
    for (int k = DEPTH_PARTS - 1; k >= 0; k--) {
        fmpq_mul_ui(scaled, scaled, 1000);
        d->deeper[k] += fmpq_cmp(scaled, d->size) > 0;
    }
}

/* Count a row by the bounds of its distance, which become their sizes; *out is the larger one. */
static graze_status count_depth(ceiling *out, depths *d, graze_context *context, int pmc,
                                fmpq_t low, fmpq_t high) {
    int apart = fmpq_sgn(low) * fmpq_sgn(high) > 0;
    fmpq_abs(low, low);
    fmpq_abs(high, high);
    int falls = fmpq_cmp(low, high) > 0;
    *out = ceiling_of(falls ? low : high);
    if (apart && !fmpq_is_zero(d->size))
        count_parts(d, falls ? high : low);
    return errors_add(&d->by[pmc], (value_error){*out, out->digits > 0, 0})
               ? GRAZE_OK
               : context_fail(context, GRAZE_ESYSTEM, "out of memory");
}

graze_status depth_take(ceiling *out, depths *d, const table *golden, const table_row *row,
                        int pmc) {
    graze_context *context = golden->in.context;
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    d->wrong++;
    TRY(table_number(low, context, table_field(golden, row, COLUMN_SDF_LOW)));
    TRY(table_number(high, context, table_field(golden, row, COLUMN_SDF_HIGH)));
    return count_depth(out, d, context, pmc, low, high);
}

graze_status depth_scale(depths *d, graze_context *context, const graze_scene *scene) {
    double diagonal;
    TRY(distance_diagonal(&diagonal, context, scene));
    return rational_from_double(d->size, context, diagonal);
}

static graze_status enclose_deep(distance *out, graze_context *context, const graze_scene *scene,
                                 const fmpq *point, double width) {
    graze_trace trace;
    graze_status status =
        classify_point(&trace, context, scene, (query_point){.rational = point}, TRACE_CONTACTS);
    if (status)
        return status;
    status = distance_find(out, context, scene, point, &trace, width);
    trace_clear(&trace);
    return status;
}

graze_status depth_measure(depth_bounds *out, depths *d, graze_context *context,
                           const graze_scene *scene, const char *point, int pmc) {
    slong dimension = scene->motion->dimension;
    LOCAL_VEC(fmpq, at, dimension);
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    distance found;
    for (slong k = 0; k < dimension; k++) {
        size_t length = strcspn(point, " ");
        TRY(rational_parse(at + k, context, point, length));
        point += length + (point[length] == ' ');
    }
    TRY(enclose_deep(&found, context, scene, at, DEPTH_WIDTH * fmpq_get_d(d->size)));
    TRY(rational_from_double(low, context, found.low));
    TRY(rational_from_double(high, context, found.high));
    report_bound(out->low, found.low, 0);
    report_bound(out->high, found.high, 1);
    return count_depth(&out->size, d, context, pmc, low, high);
}
