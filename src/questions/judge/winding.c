/* Memberships from crossings of a ray. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/judge/winding.h"

#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include "input/solid/locate.h"

mesh_place judged_place(long *winding, const judged_mesh *m, const fmpq *point) {
    skin triangles = judged_skin(m);
    fmpz *x = _fmpz_vec_init(4);
    int on;
    _fmpq_vec_get_fmpz_vec_fmpz(x, x + 3, point, 3);
    long crossings = skin_winding(&on, &triangles, x);
    _fmpz_vec_clear(x, 4);
    *winding = m->rule == GRAZE_MESH_WINDING && !on ? crossings : 0;
    if (on)
        return MESH_ON;
    if (m->rule == GRAZE_MESH_NONE)
        return MESH_UNTOLD;
    int inside = m->rule == GRAZE_MESH_WINDING ? crossings != 0 : crossings % 2 != 0;
    return inside ? MESH_IN : MESH_OUT;
}
