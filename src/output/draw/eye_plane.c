/* Values of a curved solid's surfaces in doubles, and its outline in the plane.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Values are scaled, since only signs and directions are needed. The boundary crosses a side of a
 * lattice's square if the expression holds at one end alone.
 */
#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"
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

/* SQUARES along a side of the lattice; HALVINGS of a square's side to find its crossing. */
enum { SQUARES = 256, ACROSS = SQUARES + 1, HALVINGS = 16 };

typedef struct outliner {
    graze_context *context;
    eye_field field;
    graze_solid *out;
    double low[2], step[2];
    unsigned char *inside; /* by corner */
    uint32_t *crossing; /* by side, horizontal ones at even indices: vertex of the crossing + 1 */
    size_t room, item_room; /* capacity for vertices and for segments */
} outliner;

static graze_status prepare_outline(outliner *o, const csg *solid) {
    TRY(eye_field_make(&o->field, o->context, solid));
    TRY(MAKE_ARRAY(o->context, o->inside, ACROSS * ACROSS, "a picture of the solid"));
    return MAKE_ARRAY(o->context, o->crossing, 2 * ACROSS * ACROSS, "a picture of the solid");
}

/* Coordinate `axis` of a lattice corner. Corners are a little off the ends of the box. */
static double lattice_place_of(const outliner *o, int axis, double k) {
    return o->low[axis] + (k - .37) * o->step[axis];
}

/* Is the place of lattice coordinates inside? */
static int holds_at(outliner *o, double i, double j) {
    const double place[2] = {lattice_place_of(o, 0, i), lattice_place_of(o, 1, j)};
    return eye_field_holds(&o->field, place);
}

/* Find the vertex on the side that begins at a corner; the side is vertical if `up`. */
static graze_status find_side_point(uint32_t *out, outliner *o, size_t i, size_t j, int up) {
    uint32_t *known = &o->crossing[2 * (j * ACROSS + i) + (size_t)up];
    size_t n = o->out->input.vertex_count;
    double from = 0, to = 1;
    int begins = o->inside[j * ACROSS + i];
    if (!*known) {
        TRY(ARRAY_GROW(o->context, o->out->low, o->room, 2 * n + 2, "an outline"));
        double at[2] = {(double)i, (double)j};
        for (int k = 0; k < HALVINGS; k++) {
            double middle = (from + to) / 2;
            at[up] = (double)(up ? j : i) + middle;
            *(holds_at(o, at[0], at[1]) == begins ? &from : &to) = middle;
        }
        for (int axis = 0; axis < 2; axis++)
            o->out->low[2 * n + (size_t)axis] = lattice_place_of(o, axis, at[axis]);
        *known = (uint32_t)++o->out->input.vertex_count;
    }
    *out = *known - 1;
    return GRAZE_OK;
}

/* Add the segments of a square, which join its crossed sides two by two in their order around it.
 */
static graze_status add_square(outliner *o, size_t i, size_t j) {
    static const unsigned char side[4][3] = {{0, 0, 0}, {1, 0, 1}, {0, 1, 0}, {0, 0, 1}};
    simplices *cut = &o->out->cut;
    uint32_t vertex[4];
    size_t count = 0;
    for (int k = 0; k < 4; k++) {
        size_t a = i + side[k][0], b = j + side[k][1];
        int up = side[k][2];
        size_t other = up ? (b + 1) * ACROSS + a : b * ACROSS + a + 1;
        if (o->inside[b * ACROSS + a] != o->inside[other])
            TRY(find_side_point(&vertex[count++], o, a, b, up));
    }
    for (size_t k = 0; k + 1 < count; k += 2) {
        TRY(ARRAY_GROW(o->context, cut->item, o->item_room, cut->count + 1, "an outline"));
        cut->item[cut->count++] = (simplex){.vertex = {vertex[k], vertex[k + 1], 0}};
    }
    return GRAZE_OK;
}

static graze_status trace_outline(outliner *o) {
    for (size_t k = 0; k < ACROSS * ACROSS; k++) {
        o->inside[k] = (unsigned char)holds_at(o, (double)(k % ACROSS), (double)(k / ACROSS));
        TRY(context_poll(o->context));
    }
    for (size_t k = 0; k < SQUARES * SQUARES; k++)
        TRY(add_square(o, k % SQUARES, k / SQUARES));
    return GRAZE_OK;
}

graze_status eye_outline_make(graze_solid *out, graze_context *context, const csg *solid) {
    outliner o = {.context = context, .out = out};
    for (int k = 0; k < 2; k++) {
        double high = fmpq_get_d(&solid->box.high[k]);
        o.low[k] = fmpq_get_d(&solid->box.low[k]);
        o.step[k] = (high - o.low[k]) / (SQUARES - 1);
    }
    graze_status status = prepare_outline(&o, solid);
    if (!status)
        status = trace_outline(&o);
    eye_field_clear(&o.field);
    free(o.inside);
    free(o.crossing);
    return status;
}
