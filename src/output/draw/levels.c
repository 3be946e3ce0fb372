/* Measures cells, and writes the numbers of their levels.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/draw.h"

#include <flint/fmpq_vec.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "base/context/scope.h"
#include "base/number/decimal.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"
#include "output/draw/panel.h"
#include "output/draw/views.h"
#include "questions/distance/distance.h"

/* Cells' sides in one width of an enclosure. */
enum { FINENESS = 64 };

/* The answer of a point as a tone, and the middle of its distance's enclosure. */
static graze_status measure_point(unsigned char *side, double *middle, graze_context *context,
                                  const graze_scene *scene, const fmpq *point, double width) {
    graze_trace trace;
    distance found;
    graze_status status =
        classify_point(&trace, context, scene, (query_point){.rational = point}, TRACE_CONTACTS);
    if (status)
        return status;
    status = distance_find(&found, context, scene, point, &trace, width);
    *side = (unsigned char)(TONE_IN - 1 + (int)trace.verdict.pmc);
    trace_clear(&trace);
    *middle = found.low + (found.high - found.low) / 2;
    return status;
}

/* A step of 1, 2 or 5 of a power of ten, so that the bands reach to the farthest cell. */
static void choose_step(cells *c) {
    static const int digits[] = {1, 2, 5, 10};
    double most = 0;
    for (size_t k = 0; k < c->count[0] * c->count[1]; k++)
        most = fmax(most, fabs(c->distance[k]));
    double wanted = most > 0 ? most / BANDS : 1;
    c->step_exponent = (int)floor(log10(wanted));
    for (int k = 0; k < 4; k++) {
        c->step_digit = digits[k];
        c->step = digits[k] * pow(10, c->step_exponent);
        if (c->step >= wanted)
            return;
    }
}

static tone band_of(const cells *c, tone side, double value) {
    int k = (int)fmin(fabs(value) / c->step, BANDS - 1);
    return side == TONE_IN    ? (tone)(TONE_INNER + k)
           : side == TONE_OUT ? (tone)(TONE_OUTER + k)
                              : side;
}

graze_status cells_measure(cells *c, graze_context *context, const graze_scene *scene) {
    size_t count = c->count[0] * c->count[1];
    double width = fmpq_get_d(c->side) / FINENESS;
    c->distance = calloc(count, sizeof *c->distance);
    if (!c->distance)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for the cells of a picture");
    LOCAL_VEC(fmpq, point, 3);
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < count && !status; k++) {
        cells_place(point, c, 2, 2 * (k % c->count[0]) + 1, 2 * (k / c->count[0]) + 1);
        status = measure_point(&c->tone[k], &c->distance[k], context, scene, point, width);
        if (!status)
            status = context_poll(context);
    }
    choose_step(c);
    for (size_t k = 0; k < count && !status; k++)
        c->tone[k] = (unsigned char)band_of(c, (tone)c->tone[k], c->distance[k]);
    return status;
}

int level_text(char out[LEVEL_ROOM], const cells *c, int k) {
    int exact;
    LOCAL(fmpq, value);
    LOCAL(fmpz, ten);
    fmpz_set_ui(ten, 10);
    fmpz_pow_ui(ten, ten, (ulong)abs(c->step_exponent));
    fmpq_set_si(value, k * c->step_digit, 1);
    if (c->step_exponent < 0)
        fmpq_div_fmpz(value, value, ten);
    else
        fmpq_mul_fmpz(value, value, ten);
    char *decimal = decimal_of_rational(&exact, value, 10);
    snprintf(out, LEVEL_ROOM, "%s", decimal ? decimal : "");
    int made = decimal != NULL;
    free(decimal);
    return made;
}

int band_text(char out[BAND_ROOM], const cells *c, tone t) {
    char from[LEVEL_ROOM], to[LEVEL_ROOM];
    int k = t >= TONE_OUTER ? (int)(t - TONE_OUTER) : -1 - (int)(t - TONE_INNER);
    int made = level_text(from, c, k) && level_text(to, c, k + 1);
    snprintf(out, BAND_ROOM, "%s to %s", from, to);
    return made;
}
