/* Squares of a lattice, whose sides are crossed where the expression changes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdlib.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "input/csg/csg.h"
#include "input/solid/solid.h"
#include "input/validate/validate.h"
#include "output/draw/panel.h"

/* Squares along a side; halvings of a side that is crossed. */
enum { SQUARES = 256, ACROSS = SQUARES + 1, HALVINGS = 16 };

typedef struct outliner {
    graze_context *context;
    eye_field field;
    graze_solid *out;
    double low[2], step[2];
    unsigned char *inside;  /* by corner */
    uint32_t *crossing;     /* by side, horizontal ones at even places: its vertex + 1 */
    size_t room, item_room; /* of vertices, of segments */
} outliner;

static int holds_at(outliner *o, double x, double y) {
    return eye_field_holds(&o->field, (double[]){x, y});
}

static graze_status prepare_outline(outliner *o, const csg *solid) {
    graze_status status = eye_field_make(&o->field, o->context, solid);
    o->inside = calloc(ACROSS * ACROSS, 1);
    o->crossing = calloc(2 * ACROSS * ACROSS, sizeof *o->crossing);
    if (!status && (!o->inside || !o->crossing))
        status =
            context_fail(o->context, GRAZE_ESYSTEM, "out of memory for a picture of the solid");
    return status;
}

/* Coordinate `axis` of a corner, a little off the box's own ends. */
static double lattice_place_of(const outliner *o, int axis, double k) {
    return o->low[axis] + (k - .37) * o->step[axis];
}

/* The vertex on a side that begins at a corner; `up`: a vertical one. */
static graze_status find_side_point(uint32_t *out, outliner *o, size_t i, size_t j, int up) {
    uint32_t *known = &o->crossing[2 * (j * ACROSS + i) + (size_t)up];
    size_t n = o->out->input.vertex_count;
    double from = 0, to = 1;
    int begins = o->inside[j * ACROSS + i];
    graze_status status = GRAZE_OK;
    if (!*known)
        status = array_grow(o->context, &o->out->low, &o->room, 2 * n + 2, sizeof *o->out->low,
                            "an outline");
    if (!*known && !status) {
        double at[2] = {(double)i, (double)j};
        for (int k = 0; k < HALVINGS; k++) {
            double middle = (from + to) / 2;
            at[up] = (double)(up ? j : i) + middle;
            int same =
                holds_at(o, lattice_place_of(o, 0, at[0]), lattice_place_of(o, 1, at[1])) == begins;
            *(same ? &from : &to) = middle;
        }
        for (int axis = 0; axis < 2; axis++)
            o->out->low[2 * n + (size_t)axis] = lattice_place_of(o, axis, at[axis]);
        *known = (uint32_t)++o->out->input.vertex_count;
    }
    *out = *known - 1;
    return status;
}

/* The segments of a square: its crossed sides, in the order around it, two by two. */
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
        TRY(array_grow(o->context, &cut->item, &o->item_room, cut->count + 1, sizeof *cut->item,
                       "an outline"));
        cut->item[cut->count++] = (simplex){.vertex = {vertex[k], vertex[k + 1], 0}};
    }
    return GRAZE_OK;
}

static graze_status trace_outline(outliner *o) {
    for (size_t k = 0; k < ACROSS * ACROSS; k++) {
        double i = (double)(k % ACROSS), j = (double)(k / ACROSS);
        o->inside[k] =
            (unsigned char)holds_at(o, lattice_place_of(o, 0, i), lattice_place_of(o, 1, j));
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
