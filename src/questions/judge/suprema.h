/* The greatest distances between a mesh and the boundary of a sweep, each way, enclosed.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_SUPREMA_H
#define GRAZE_JUDGE_SUPREMA_H

#include "questions/judge/open_search.h"

/**
 * Search (proofs/judging.md C119): over the mesh the greatest distance to the sweep of its points
 * outside, and to the complement of those inside; over the sweep's boundary that to the mesh.
 * @param within positive
 * @param threads for the volume; they change nothing but the time
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM; suprema_clear in any case
 */
graze_status suprema_find(suprema *out, graze_context *context, const graze_scene *scene,
                          const judged_mesh *mesh, double within, size_t budget, int threads);
void suprema_clear(suprema *s);

#endif
