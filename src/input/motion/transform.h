/* Transforms of a motion file: JSON to affine maps over a stretch of a piece
 * (src/program/cli/formats.md, Motions). SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MOTION_TRANSFORM_H
#define GRAZE_MOTION_TRANSFORM_H

#include "input/motion/affine.h"
#include "input/motion/entry.h"

/** Places in s at which the turns of a transform cut its piece, ascending, each once, from 0 to 1.
 */
typedef struct cut_list {
    size_t count, capacity; /* places up to `capacity` are initialised */
    fmpq *place;
} cut_list;

void cut_list_init(cut_list *cuts);
void cut_list_clear(cut_list *cuts);
/** @return GRAZE_ELIMIT more parts than the limit `pieces`; what transform_map returns */
graze_status transform_cuts(cut_list *cuts, graze_context *context, const json *transform);

/**
 * The map of a transform over one stretch between two of its cuts.
 * @param[out] out initialised, of the stretch's dimension
 * @return GRAZE_EINPUT keys, types, expressions; GRAZE_EILLEGAL an axis whose length is not a
 * rational function, vanishes or has a pole, a quaternion that vanishes, and what the
 * stretch's fault says: an entry with a pole, or a singular scale or matrix; GRAZE_ELIMIT
 */
graze_status transform_map(affine *out, graze_context *context, const json *transform,
                           const stretch *part);

#endif
