/* The search for the greatest distance of the sweep's boundary to the mesh.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_SEARCH_SWEEP_H
#define GRAZE_JUDGE_SEARCH_SWEEP_H

#include "questions/judge/open_search.h"

/** Begin with all of space; the mesh has triangles. */
graze_status search_sweep_begin(suprema *s);
/** A step: the cube that waits first is taken up. */
graze_status search_sweep_step(suprema *s);

#endif
