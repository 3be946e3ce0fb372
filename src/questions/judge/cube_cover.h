/* Test whether a few positions of the solid together cover a cube.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_CUBE_COVER_H
#define GRAZE_JUDGE_CUBE_COVER_H

#include "decide/lattice/cell_asker.h"
#include "questions/judge/cube.h"

/** Try to cover a closed cube by positions of the solid (proofs/judging.md C124). At a seam several
 * positions are needed.
 * @param[out] done 1: all of the cube is in the sweep
 * @return GRAZE_ECANCELED, GRAZE_ESYSTEM */
graze_status cube_is_covered(int *done, cell_asker *ask, const cube *of);

#endif
