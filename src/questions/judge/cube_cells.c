/* A cube is six tetrahedra; a plane cuts one in two at an edge that goes through it, until none
 * does. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/judge/cube.h"

#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "base/number/vector.h"

void cube_cells_init(cube_cells *c, graze_context *context) {
    *c = (cube_cells){.context = context, .plane = _fmpq_vec_init(4 * CUBE_PLANES)};
}

static void forget_cells(cube_cells *c) {
    for (size_t k = 0; k < c->count; k++)
        for (int i = 0; i < 4; i++)
            fmpq_clear(c->item[k].at + i);
    c->count = c->parts = 0;
}

void cube_cells_clear(cube_cells *c) {
    forget_cells(c);
    free(c->item);
    _fmpq_vec_clear(c->plane, 4 * CUBE_PLANES);
}

/* The first coefficient of n is made 1 or -1. */
void cube_cells_plane(cube_cells *c, const fmpq *plane) {
    fmpq *own = c->plane + 4 * (c->plane_count < CUBE_PLANES ? c->plane_count : 0);
    int lead = 0, found = 0;
    forget_cells(c);
    c->failed |= c->plane_count == CUBE_PLANES;
    while (fmpq_is_zero(plane + lead))
        lead++;
    for (int i = 0; i < 4 && !c->failed; i++)
        fmpq_div(own + i, plane + i, plane + lead);
    for (int k = 0; k < c->plane_count && !found && !c->failed; k++) {
        found = 1;
        for (int i = 0; i < 4; i++)
            found &= fmpq_equal(c->plane + 4 * k + i, own + i);
    }
    c->plane_count += !found && !c->failed;
}

/* Add a tetrahedron of four corners to its cell. */
static graze_status add_to_cell(cube_cells *c, const fmpq *corner, unsigned sides) {
    size_t k = 0;
    c->parts++;
    while (k < c->count && c->item[k].sides != sides)
        k++;
    TRY(ARRAY_GROW(c->context, c->item, c->capacity, k + 1, "cells of a cube"));
    LOCAL_VEC(fmpq, e, 13);
    fmpq *at = c->item[k].at;
    if (k == c->count) {
        c->count++;
        c->item[k].sides = sides;
        for (int i = 0; i < 4; i++)
            fmpq_init(at + i);
        for (int i = 0; i < 12; i++)
            fmpq_add(at + i % 3, at + i % 3, corner + i);
        for (int i = 0; i < 3; i++)
            fmpq_div_2exp(at + i, at + i, 2);
    }
    for (int i = 0; i < 9; i++)
        fmpq_sub(e + i, corner + 3 + i, corner + i % 3);
    vector_cross(e + 9, e + 3, e + 6);
    _fmpq_vec_dot(e + 12, e, e + 9, 3);
    fmpq_abs(e + 12, e + 12);
    fmpq_div_fmpz(e + 12, e + 12, (fmpz[]){6});
    fmpq_add(at + 3, at + 3, e + 12);
    return GRAZE_OK;
}

/* Cut a tetrahedron by plane k and those behind it. */
static graze_status cut_tetrahedron(cube_cells *c, const fmpq *corner, int k, unsigned sides) {
    int high = -1, low = -1;
    c->failed |= c->count > CUBE_CELLS || c->parts > CUBE_PARTS;
    if (c->failed)
        return GRAZE_OK;
    if (k == c->plane_count)
        return add_to_cell(c, corner, sides);
    LOCAL_VEC(fmpq, value, 16);
    fmpq *part = value + 4;
    for (int v = 0; v < 4; v++) {
        _fmpq_vec_dot(value + v, c->plane + 4 * k, corner + 3 * v, 3);
        fmpq_add(value + v, value + v, c->plane + 4 * k + 3);
        high = fmpq_sgn(value + v) > 0 ? v : high;
        low = fmpq_sgn(value + v) < 0 ? v : low;
    }
    if (high < 0 || low < 0) {
        TRY(cut_tetrahedron(c, corner, k + 1, sides | (unsigned)(high >= 0) << k));
    } else {
        for (int half = 0; half < 2; half++) {
            vector_set(part, corner, 12);
            vector_zero(part + 3 * (half ? low : high), corner + 3 * high, corner + 3 * low,
                        value + high, value + low, 3);
            TRY(cut_tetrahedron(c, part, k, sides));
        }
    }
    return GRAZE_OK;
}

graze_status cube_cells_make(cube_cells *c, const cube *of) {
    LOCAL_VEC(fmpq, corner, 12);
    forget_cells(c);
    for (int order = 0; order < 6; order++) {
        /* from the lowest corner to the highest along the axes in one order */
        int next = order % 3,
            axis[3] = {next, (next + 1 + order / 3) % 3, (next + 2 - order / 3) % 3};
        double at[3];
        for (int i = 0; i < 3; i++)
            at[i] = of->centre[i] - of->half;
        for (int v = 0; v < 4; v++) {
            for (int i = 0; i < 3; i++)
                (void)rational_from_double(corner + 3 * v + i, NULL, at[i]);
            if (v < 3)
                at[axis[v]] = of->centre[axis[v]] + of->half;
        }
        TRY(cut_tetrahedron(c, corner, 0, 0));
    }
    return GRAZE_OK;
}
