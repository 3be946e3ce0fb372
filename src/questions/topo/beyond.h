/* Points outside the closed set that positions are relative to: witnesses of its boundary.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_BEYOND_H
#define GRAZE_TOPO_BEYOND_H

#include "decide/scene/scene.h"

/** Is a point `out` of a sweep; for an unsweep: is it `in`? The complement of an unsweep is the
 * sweep of the solid's complement (proofs/dangling.md C113).
 * @return as classify_verdict */
graze_status beyond_closed(int *out, graze_context *context, const graze_scene *scene,
                           const fmpq *point);

#endif
