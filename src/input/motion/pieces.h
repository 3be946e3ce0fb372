/* Motions made of pieces and of keyframes, from parsed JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MOTION_PIECES_H
#define GRAZE_MOTION_PIECES_H

#include "input/motion/draft.h"
#include "input/motion/json_tree.h"

/** The two forms made of frames and of pieces; `out` is empty and has its dimension. */
graze_status motion_read_pieces(draft *out, graze_context *context, const json *pieces);
graze_status motion_read_keyframes(draft *out, graze_context *context, const json *keyframes);

#endif
