/* The common kernel of all normals about the point, which are functions of time: it is the kernel
 * of all their coefficients.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/topo/topo.h"

#include <flint/fmpz_vec.h>
#include "base/context/scope.h"
#include "decide/trace/trace.h"
#include "input/motion/motion.h"
#include "questions/topo/cover.h"
#include "questions/topo/near.h"

/* Add a normal's coefficients of all powers of time. */
static void span_add_normal(direction_span *s, const point_map *map, const fmpz *normal) {
    static const fmpz axis[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    slong length = 0;
    LOCAL_VEC(fmpz, v, 3);
    LOCAL_VEC(fmpz_poly, entry, 3);
    for (int i = 0; i < 3; i++) {
        signs_pull_back(entry + i, map, normal, axis[i]);
        length = FLINT_MAX(length, fmpz_poly_length(entry + i));
    }
    for (slong k = 0; k < length; k++) {
        for (int i = 0; i < 3; i++)
            fmpz_poly_get_coeff_fmpz(v + i, entry + i, k);
        direction_span_add(s, v);
    }
}

/* Return 1 and set a plane's normal about the point if the plane does not move and contains the
 * trajectory; else return 0. */
static int plane_stays(fmpz *normal, const germ *g, size_t j, const fmpq *point) {
    LOCAL_VEC(fmpz, basis, 9);
    direction_span s = {0, basis};
    HELD(trajectory, path, 3);
    LOCAL(fmpz_poly, away);
    trajectory_set(&path, g->map, point);
    distance_from_plane(away, &g->cone, j, &path);
    span_add_normal(&s, g->map, g->cone.normal + 3 * j);
    int stays = fmpz_poly_is_zero(away) && s.rank == 1;
    _fmpz_vec_set(normal, s.basis, 3);
    return stays;
}

/* Find a vector of the kernel of all normals; if `step` is not NULL, without the planes across
 * `step` that stay (plane_stays). */
static int find_kernel(fmpz *out, const germ_list *list, const fmpz *step, const fmpq *point) {
    LOCAL_VEC(fmpz, basis, 9);
    direction_span s = {0, basis};
    LOCAL_VEC(fmpz, stays, 3);
    for (size_t k = 0; k < list->count && s.rank < 3; k++) {
        const germ *g = &list->item[k];
        for (size_t j = 0; j < g->cone.count && s.rank < 3; j++)
            if (!step || !plane_stays(stays, g, j, point) || !directions_parallel(stays, step))
                span_add_normal(&s, g->map, g->cone.normal + 3 * j);
    }
    if (s.rank == 1)
        directions_basis(s.basis + 6, s.basis + 3, s.basis);
    int found = s.rank == 1 || s.rank == 2;
    if (found)
        _fmpz_vec_set(out, s.basis + 6, 3);
    return found;
}

int invariant_direction(fmpz *out, const germ_list *list) {
    return find_kernel(out, list, NULL, NULL);
}

int invariant_beside_step(fmpz *out, fmpz *step, const germ_list *list, const fmpq *point) {
    int found = 0;
    LOCAL_VEC(fmpz, normal, 3);
    LOCAL(fmpz, product);
    _fmpz_vec_zero(step, 3);
    for (size_t k = 0; k < list->count && !found; k++)
        for (size_t j = 0; j < list->item[k].cone.count && !found; j++) {
            if (!plane_stays(normal, &list->item[k], j, point) || _fmpz_vec_equal(normal, step, 3))
                continue;
            _fmpz_vec_set(step, normal, 3);
            found = find_kernel(out, list, step, point);
            _fmpz_vec_dot(product, step, out, 3);
            found = found && !fmpz_is_zero(product);
        }
    if (!found)
        _fmpz_vec_zero(step, 3);
    return found;
}
