/* The search for the greatest distance of the sweep's boundary to the mesh.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_SEARCH_SWEEP_H
#define GRAZE_JUDGE_SEARCH_SWEEP_H

#include "questions/judge/open_search.h"

/** Begin with one cube, the root; the mesh has triangles. */
graze_status search_sweep_begin(suprema *s);
/** Do a step: process the cube with the greatest bound. */
graze_status search_sweep_step(suprema *s);

#endif
