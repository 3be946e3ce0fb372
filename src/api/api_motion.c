/* The public functions of motions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

graze_status graze_motion_read(graze_motion **out, graze_context *context, const char *path) {
    PUBLIC_OUT(out, context, path);
    return motion_from_file(out, context, path);
}

graze_status graze_motion_from_json(graze_motion **out, graze_context *context, const char *text,
                                    size_t length) {
    PUBLIC_OUT(out, context, text);
    return motion_from_text(out, context, text, length);
}

void graze_motion_destroy(graze_motion *motion) {
    if (motion)
        motion_destroy(motion);
}

FACT(int, graze_motion_dimension, graze_motion, of->dimension, 0)
FACT(size_t, graze_motion_piece_count, graze_motion, of->piece_count, 0)

graze_status graze_motion_text(char **out, graze_context *context, const graze_motion *motion) {
    PUBLIC_OUT(out, context, motion);
    HELD(text, t);
    motion_write(&t, motion);
    return text_finish(out, context, &t);
}
