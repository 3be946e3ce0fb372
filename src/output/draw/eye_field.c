/* Surfaces' values in doubles, scaled, since only signs and directions are asked for.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpz.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "input/csg/csg.h"
#include "output/draw/panel.h"

static void put_scaled(double *out, const csg_surface *s) {
    slong shift = 0, most = 0;
    for (size_t i = 0; i < s->count; i++)
        most = FLINT_MAX(most, (slong)fmpz_bits(s->coefficient + i));
    for (size_t i = 0; i < s->count; i++) {
        double mantissa = fmpz_get_d_2exp(&shift, s->coefficient + i);
        out[i] = ldexp(mantissa, (int)FLINT_MAX(shift - most, -2000));
    }
}

graze_status eye_field_make(eye_field *out, graze_context *context, const csg *solid) {
    size_t terms = 0, n = 0;
    for (size_t k = 0; k < solid->surface_count; k++)
        terms += solid->surface[k].count;
    *out = (eye_field){.solid = solid,
                       .coefficient = malloc((terms + 1) * sizeof *out->coefficient),
                       .sign = malloc(solid->surface_count + 1),
                       .other = malloc(solid->surface_count + 1),
                       .truth = malloc(solid->node_count * sizeof *out->truth)};
    if (!out->coefficient || !out->sign || !out->other || !out->truth)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a picture of the solid");
    for (size_t k = 0; k < solid->surface_count; n += solid->surface[k++].count)
        put_scaled(out->coefficient + n, &solid->surface[k]);
    return GRAZE_OK;
}

void eye_field_clear(eye_field *field) {
    free(field->coefficient);
    free(field->sign);
    free(field->other);
    free(field->truth);
    *field = (eye_field){.solid = NULL};
}

static double surface_value(const csg_surface *s, const double *coefficient, const double *at,
                            int dimension) {
    double sum = 0;
    for (size_t k = 0; k < s->count; k++) {
        double term = coefficient[k];
        for (int i = 0; i < dimension; i++)
            for (int power = 0; power < s->power[k][i]; power++)
                term *= at[i];
        sum += term;
    }
    return sum;
}

static void put_field_signs(signed char *out, const eye_field *field, const double *at) {
    const double *coefficient = field->coefficient;
    const csg *solid = field->solid;
    for (size_t k = 0; k < solid->surface_count; coefficient += solid->surface[k++].count) {
        double value = surface_value(&solid->surface[k], coefficient, at, solid->dimension);
        out[k] = value < 0 ? -1 : 1;
    }
}

int eye_field_holds(eye_field *field, const double *at) {
    uint64_t all;
    put_field_signs(field->sign, field, at);
    csg_table(&all, field->truth, field->solid, field->sign, 0);
    return all == 1;
}

void eye_field_normal(double out[3], eye_field *field, const double *from, const double *to,
                      double step) {
    const csg *solid = field->solid;
    const double *coefficient = field->coefficient;
    double length = 0, along = 0;
    size_t k = 0;
    memset(out, 0, 3 * sizeof *out);
    put_field_signs(field->sign, field, from);
    put_field_signs(field->other, field, to);
    while (k < solid->surface_count && field->sign[k] == field->other[k])
        coefficient += solid->surface[k++].count;
    for (int i = 0; i < solid->dimension && k < solid->surface_count; i++) {
        double ahead[3] = {from[0], from[1], solid->dimension == 3 ? from[2] : 0}, behind[3];
        memcpy(behind, ahead, sizeof behind);
        ahead[i] += step;
        behind[i] -= step;
        out[i] = surface_value(&solid->surface[k], coefficient, ahead, solid->dimension) -
                 surface_value(&solid->surface[k], coefficient, behind, solid->dimension);
        length += out[i] * out[i];
        along += out[i] * (to[i] - from[i]);
    }
    for (int i = 0; i < 3 && length > 0; i++)
        out[i] *= (along < 0 ? -1 : 1) / sqrt(length);
}
