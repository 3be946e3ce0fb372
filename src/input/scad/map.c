/* Reads and composes maps, and bounds what they do.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "input/csg/csg.h"
#include "input/scad/writer.h"

/* Binary places of bounds. */
enum { BOUND_BITS = 60 };

void scad_map_init(scad_map *m) {
    m->linear = _fmpq_vec_init(12);
    m->shift = m->linear + 9;
    fmpq_init(m->error);
}

void scad_map_clear(scad_map *m) {
    _fmpq_vec_clear(m->linear, 12);
    fmpq_clear(m->error);
}

/* Reduce a map to one of the plane, as OpenSCAD does. The third axis is scaled about as the plane
 * is, so that scad_turn sees a rotation where there is one. */
static void flatten_map(scad_map *m) {
    LOCAL(fmpq, square);
    for (int k = 0; k < 5; k++)
        if (k != 2)
            fmpq_addmul(square, m->linear + k, m->linear + k);
    fmpq_div_2exp(square, square, 1);
    for (int i = 0; i < 3; i++) {
        fmpq_zero(m->linear + 6 + i);
        fmpq_zero(m->linear + 3 * i + 2);
    }
    csg_upper_root(m->linear + 8, square);
    fmpq_zero(m->shift + 2);
}

graze_status scad_map_read(scad_map *out, scad_writer *w, const scad_place *p, int *turned) {
    field value, rest = {"", 0}, row;
    LOCAL_VEC(fmpq, v, 16);
    int rows = 0;
    if (scad_value(&value, p, NULL))
        TRY(scad_list(&rest, p, value));
    for (; scad_item(&row, &rest); rows++)
        if (rows < 4)
            TRY(scad_vector(v + 4 * rows, p, row, 4));
    if (rows != 4 || !vector_is_zero(v + 12, 3) || !fmpq_is_one(v + 15))
        return scad_fail(p, GRAZE_EINPUT, "expected 4 rows of 4 numbers, the last one 0, 0, 0, 1");
    for (int i = 0; i < 3; i++) {
        fmpq_set(out->shift + i, v + 4 * i + 3);
        vector_set(out->linear + 3 * i, v + 4 * i, 3);
    }
    if (p->file->node[p->node].dimension == 2)
        flatten_map(out);
    *turned = w->choice->near_rotation &&
              scad_turn(out->linear, out->error, w->context, w->choice->near_rotation);
    return GRAZE_OK;
}

void scad_compose(fmpq *out, const fmpq *map, const scad_map *m) {
    for (int i = 0; i < 2; i++, map += 3, out += 3) {
        for (int j = 0; j < 3; j++) {
            const fmpq *x = j < 2 ? m->linear + j : m->shift, *y = j < 2 ? x + 3 : x + 1;
            fmpq_mul(out + j, map, x);
            fmpq_addmul(out + j, map + 1, y);
        }
        fmpq_add(out + 2, out + 2, map + 2);
    }
}

/* Round a number up to BOUND_BITS binary places. */
static void round_up(fmpq_t x) {
    fmpz_mul_2exp(fmpq_numref(x), fmpq_numref(x), BOUND_BITS);
    fmpz_cdiv_q(fmpq_numref(x), fmpq_numref(x), fmpq_denref(x));
    fmpz_one(fmpq_denref(x));
    fmpq_div_2exp(x, x, BOUND_BITS);
}

void scad_map_bounds(scad_writer *w, const scad_map *m) {
    LOCAL_VEC(fmpq, v, 2);
    fmpq *norm = v, *far = v + 1;
    scad_norm(norm, m->linear);
    fmpq_mul(w->moved, w->moved, norm);
    fmpq_addmul(w->moved, m->error, w->reach);
    fmpq_mul(w->reach, w->reach, norm);
    scad_hold(far, m->shift, 3);
    fmpq_add(w->reach, w->reach, far);
    round_up(w->reach);
    round_up(w->moved);
}
