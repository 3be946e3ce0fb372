/* A ray from a point, clear of the boundary of the closed sweep up to some distance.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_RAY_H
#define GRAZE_TOPO_RAY_H

#include "decide/scene/scene.h"

/**
 * Find how far a ray from an `on` point of a sweep stays `out`, if it is so near the point
 * (proofs/closure.md C74): then P + s direction is `out` for 0 < s <= reach.
 * @param[out] found     0 where the ray meets facets in a special position, or the limit `bits`;
 *                       another direction can be tried
 * @param[out] reach     positive, if found
 * @param direction      d integers, not all 0
 */
graze_status ray_find_reach(int *found, fmpq_t reach, graze_context *context,
                            const graze_scene *scene, const fmpq *point, const fmpz *direction);

#endif
