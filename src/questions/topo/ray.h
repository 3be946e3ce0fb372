/* A ray from a point that is out up to some distance.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_RAY_H
#define GRAZE_TOPO_RAY_H

#include "decide/scene/scene.h"

/** Find a reach of a ray from an `on` point P of a sweep (proofs/closure.md C74): if P + s
 * direction is `out` for all small s > 0, it is `out` for 0 < s <= reach.
 * @param[out] found 0 if the ray meets facets in a special position or exceeds the limit `bits`;
 * another direction can be tried
 * @param[out] reach     positive, if found
 * @param direction      d integers, not all 0 */
graze_status ray_find_reach(int *found, fmpq_t reach, graze_context *context,
                            const graze_scene *scene, const fmpq *point, const fmpz *direction);

#endif
