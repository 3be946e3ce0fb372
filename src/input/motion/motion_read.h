/* Motions from parsed JSON: pieces, keyframes, relative, sequence (src/program/cli/formats.md,
 * Motions). SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MOTION_MOTION_READ_H
#define GRAZE_MOTION_MOTION_READ_H

#include "input/motion/draft.h"
#include "input/motion/json_tree.h"

/**
 * Read a MOTION and check that it is legal: pieces in order, no pole and no zero determinant on a
 * closed piece, continuous at the breaks; and so for every motion it is made of.
 * @param[out] out  uninitialised; the caller clears it, also after a failure
 * @param dimension dimension of the motion around this one, or 0
 * @return GRAZE_EINPUT, GRAZE_EILLEGAL, GRAZE_ELIMIT with file, line and path; GRAZE_ECANCELED
 */
graze_status motion_read_draft(draft *out, graze_context *context, const json *value,
                               int dimension);

/**
 * Read a motion file, or a text in its form (src/program/cli/formats.md, Motions).
 * @return GRAZE_ESYSTEM, GRAZE_EINPUT, GRAZE_EILLEGAL, GRAZE_ELIMIT, GRAZE_ECANCELED
 */
graze_status motion_from_file(graze_motion **out, graze_context *context, const char *path);
graze_status motion_from_text(graze_motion **out, graze_context *context, const char *text,
                              size_t length);

#endif
