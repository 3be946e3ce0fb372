/* Motions from parsed JSON: pieces, keyframes, relative, sequence (src/cli/formats.md, Motions).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MOTION_MOTION_READ_H
#define GRAZE_MOTION_MOTION_READ_H

#include "motion/draft.h"
#include "motion/json.h"

/**
 * Read a MOTION and check that it is legal: pieces in order, no pole and no zero determinant on a
 * closed piece, continuous at the breaks; and so for every motion it is made of.
 * @param[out] out  uninitialised; the caller clears it, also after a failure
 * @param dimension what the motion around this one has, or 0
 * @return GRAZE_EINPUT, GRAZE_EILLEGAL, GRAZE_ELIMIT with file, line and path; GRAZE_ECANCELED
 */
graze_status motion_read_draft(draft *out, graze_context *context, const json *value,
                               int dimension);

/** The two forms made of frames and of pieces; `out` is empty and has its dimension. */
graze_status motion_read_pieces(draft *out, graze_context *context, const json *pieces);
graze_status motion_read_keyframes(draft *out, graze_context *context, const json *keyframes);

#endif
