/* Places from the crossings of a ray. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/judge/open_search.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"

mesh_place judged_place(long *winding, const judged_mesh *m, const fmpq *point) {
    skin triangles = judged_skin(m);
    LOCAL_VEC(fmpz, x, 4);
    int on;
    _fmpq_vec_get_fmpz_vec_fmpz(x, x + 3, point, 3);
    long crossings = skin_winding(&on, &triangles, x);
    *winding = m->rule == GRAZE_MESH_WINDING && !on ? crossings : 0;
    if (on)
        return MESH_ON;
    if (m->rule == GRAZE_MESH_NONE)
        return MESH_UNTOLD;
    int inside = m->rule == GRAZE_MESH_WINDING ? crossings != 0 : crossings % 2 != 0;
    return inside ? MESH_IN : MESH_OUT;
}

/* Bound of the number of triangles whose sides are sampled, and the samples' distance from them as
 * a share of their size. */
enum { WINDING_SAMPLES = 128 };
static const double BESIDE = 0x1p-20;

void judged_windings(judged_mesh *m) {
    size_t step = m->cut.count / WINDING_SAMPLES + 1;
    LOCAL_VEC(fmpq, point, 3);
    for (size_t k = 0; m->rule == GRAZE_MESH_WINDING && m->corners.at && k < m->cut.count;
         k += step) {
        const double *v = m->corners.at + 9 * k;
        normal n;
        normal_space(&n, v, 0);
        double size = sqrt(sqrt(dot3(n.at, n.at)));
        for (int side = -1; side <= 1 && size > 0; side += 2) {
            long winding;
            for (int i = 0; i < 3; i++)
                (void)rational_from_double(point + i, NULL,
                                           (v[i] + v[3 + i] + v[6 + i]) / 3 +
                                               side * BESIDE * n.at[i] / size);
            (void)judged_place(&winding, m, point);
            m->least = winding < m->least ? winding : m->least;
            m->most = winding > m->most ? winding : m->most;
        }
    }
}
