/* Points beyond the closed set that positions are relative to: the witnesses of its boundary.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_BEYOND_H
#define GRAZE_TOPO_BEYOND_H

#include "decide/scene/scene.h"

/** Of a sweep: is a point `out`? Of an unsweep, whose complement is the sweep of the solid's
 * complement: is it `in` (proofs/dangling.md C113)?
 * @return as classify_verdict */
graze_status beyond_closed(int *out, graze_context *context, const graze_scene *scene,
                           const fmpq *point);

#endif
