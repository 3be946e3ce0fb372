/* The searches for the greatest distances of the mesh, outside the sweep and inside it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_SEARCH_MESH_H
#define GRAZE_JUDGE_SEARCH_MESH_H

#include "questions/judge/open_search.h"

/** Begin with one part, the whole mesh; it has triangles. */
graze_status search_mesh_begin(suprema *s);
/** Do a step of one of the searches: process the part with the greatest bound. */
graze_status search_outside_step(suprema *s);
graze_status search_inside_step(suprema *s);

#endif
