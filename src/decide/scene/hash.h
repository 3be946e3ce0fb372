/* The hash that identifies a scene.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SCENE_HASH_H
#define GRAZE_SCENE_HASH_H

#include "input/motion/motion.h"
#include "input/solid/solid.h"

/**
 * SHA-256 of the scene's canonical text, line by line:
 * `d N`; `v X Y [Z]` for each vertex; for each facet `f` and the vertices of its cycles, cycles
 * parted by ` |`; where a facet's simplices lie in more than one plane (it was fanned) `t A B C`
 * for each of them; for each piece of the motion `p LO HI`, then `m` and the coefficients of each
 * entry of M in the piece's own parameter, row by row, then `w` and those of the weight. Numbers
 * are those in force: after rounding, in lowest terms.
 */
graze_status scene_hash(unsigned char out[32], graze_context *context, const graze_solid *solid,
                        const graze_motion *motion);

#endif
