/* Measures cells, and finds their level lines by squares between four centres.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/levels.h"

#include <flint/fmpq_vec.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "decide/verdict/classify.h"
#include "output/draw/cell_parts.h"
#include "output/report/decimal_time.h"
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
    fmpq *point = _fmpq_vec_init(3);
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < count && !status; k++) {
        cells_centre(point, c, 1, k % c->count[0], k / c->count[0]);
        status = measure_point(&c->tone[k], &c->distance[k], context, scene, point, width);
        if (!status)
            status = context_poll(context);
    }
    _fmpq_vec_clear(point, 3);
    choose_step(c);
    for (size_t k = 0; k < count && !status; k++)
        c->tone[k] = (unsigned char)band_of(c, (tone)c->tone[k], c->distance[k]);
    return status;
}

/* The pixel of a place among the centres: i and j count cells from the first one's centre. */
static void level_pixel(double out[2], const cells *c, const panel *p, double i, double j) {
    out[0] = p->x + (i + .5) * p->width / (double)c->count[0];
    out[1] = p->y + p->height - (j + .5) * p->height / (double)c->count[1];
}

/* The places at which a value is crossed on the sides of the square of centres from (i, j) on. */
static int cross_square(double out[4][2], const cells *c, const panel *p, size_t i, size_t j,
                        double value) {
    static const int corner[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    int found = 0;
    for (int k = 0; k < 4; k++) {
        const int *from = corner[k], *to = corner[k + 1];
        double a = c->distance[(j + (size_t)from[1]) * c->count[0] + i + (size_t)from[0]];
        double b = c->distance[(j + (size_t)to[1]) * c->count[0] + i + (size_t)to[0]];
        if ((a < value) == (b < value))
            continue;
        double share = (value - a) / (b - a);
        level_pixel(out[found++], c, p, (double)i + from[0] + share * (to[0] - from[0]),
                    (double)j + from[1] + share * (to[1] - from[1]));
    }
    return found;
}

void level_path(drawn_path *out, const cells *c, const panel *p, int k) {
    for (size_t j = 0; j + 1 < c->count[1]; j++)
        for (size_t i = 0; i + 1 < c->count[0]; i++) {
            double at[4][2];
            int found = cross_square(at, c, p, i, j, k * c->step);
            for (int m = 0; m < found; m++)
                drawn_path_to(out, m % 2 ? 'L' : 'M', at[m][0], at[m][1]);
        }
}

/* The corner at the lower left of cell (i, j) of the finer grid. */
static void border_to(drawn_path *out, const cells *c, const panel *p, char verb, size_t i,
                      size_t j) {
    double at[2], parts = (double)c->parts;
    level_pixel(at, c, p, (double)i / parts - .5, (double)j / parts - .5);
    drawn_path_to(out, verb, at[0], at[1]);
}

/* The borders of a cell of the finer grid to its left and lower neighbour. */
static void add_borders(drawn_path *out, const cells *c, const panel *p, size_t i, size_t j) {
    tone side = parts_side(c, i, j);
    if (i && parts_side(c, i - 1, j) != side) {
        border_to(out, c, p, 'M', i, j);
        border_to(out, c, p, 'L', i, j + 1);
    }
    if (j && parts_side(c, i, j - 1) != side) {
        border_to(out, c, p, 'M', i, j);
        border_to(out, c, p, 'L', i + 1, j);
    }
}

void border_path(drawn_path *out, const cells *c, const panel *p) {
    size_t n = c->parts;
    for (size_t k = 0; k < c->count[0] * c->count[1]; k++)
        for (size_t part = 0; c->split[k] && part < n * n; part++)
            add_borders(out, c, p, k % c->count[0] * n + part % n, k / c->count[0] * n + part / n);
}

int level_text(char out[LEVEL_ROOM], const cells *c, int k) {
    int exact;
    fmpq_t value;
    fmpz_t ten;
    fmpq_init(value);
    fmpz_init_set_ui(ten, 10);
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
    fmpq_clear(value);
    fmpz_clear(ten);
    return made;
}

int band_text(char out[BAND_ROOM], const cells *c, tone t) {
    char from[LEVEL_ROOM], to[LEVEL_ROOM];
    int k = t >= TONE_OUTER ? (int)(t - TONE_OUTER) : -1 - (int)(t - TONE_INNER);
    int made = level_text(from, c, k) && level_text(to, c, k + 1);
    snprintf(out, BAND_ROOM, "%s to %s", from, to);
    return made;
}
