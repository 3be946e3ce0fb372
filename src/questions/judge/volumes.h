/* Volumes of the sweep and of its difference to a mesh, enclosed.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_VOLUMES_H
#define GRAZE_JUDGE_VOLUMES_H

#include "questions/judge/open_search.h"

/** Set the volumes, from the cubes as they are; IN_SWEEP alone where the mesh has no inside, or is
 * too far away (proofs/judging.md C117).
 * @return GRAZE_ECANCELED */
graze_status volumes_find(suprema *s);

#endif
