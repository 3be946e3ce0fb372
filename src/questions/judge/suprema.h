/* Enclosures of the greatest distances between a mesh and the boundary of a sweep, each way.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_SUPREMA_H
#define GRAZE_JUDGE_SUPREMA_H

#include "questions/judge/open_search.h"

/** Enclose three greatest distances (proofs/judging.md C119): of the mesh's points outside the
 * sweep to the sweep, of its points inside to the complement, and of the sweep's boundary to the
 * mesh. Enclose the volumes too.
 * @param within the width wanted, positive
 * @param budget bound of the number of cubes and points asked
 * @param threads for the volumes; their number changes nothing but the time
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM; suprema_clear in any case */
graze_status suprema_find(suprema *out, graze_context *context, const graze_scene *scene,
                          const judged_mesh *mesh, double within, size_t budget, int threads);
void suprema_clear(suprema *s);

#endif
