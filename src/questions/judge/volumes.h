/* Enclosures of the volumes of the sweep and of its differences to a mesh.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_VOLUMES_H
#define GRAZE_JUDGE_VOLUMES_H

#include "questions/judge/open_search.h"

/** Enclose the volumes from the band's cubes (proofs/judging.md C117); IN_SWEEP alone if the mesh
 * has no inside, or is too far away.
 * @return GRAZE_ECANCELED */
graze_status volumes_find(suprema *s);

#endif
