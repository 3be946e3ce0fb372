/* The public functions of motions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include "base/context/scope.h"
#include "input/motion/motion.h"

graze_status graze_motion_read(graze_motion **out, graze_context *context, const char *path) {
    if (out)
        *out = NULL;
    if (!out || !context || !path)
        return api_misuse(context, "graze_motion_read", "out, context and path must not be NULL");
    IN_ENVIRONMENT();
    return motion_from_file(out, context, path);
}

graze_status graze_motion_from_json(graze_motion **out, graze_context *context, const char *text,
                                    size_t length) {
    if (out)
        *out = NULL;
    if (!out || !context || !text)
        return api_misuse(context, "graze_motion_from_json",
                          "out, context and text must not be NULL");
    IN_ENVIRONMENT();
    return motion_from_text(out, context, text, length);
}

void graze_motion_destroy(graze_motion *motion) {
    if (motion)
        motion_destroy(motion);
}

int graze_motion_dimension(const graze_motion *motion) {
    return motion ? motion->dimension : 0;
}

size_t graze_motion_piece_count(const graze_motion *motion) {
    return motion ? motion->piece_count : 0;
}

graze_status graze_motion_text(char **out, graze_context *context, const graze_motion *motion) {
    if (out)
        *out = NULL;
    if (!out || !context || !motion)
        return api_misuse(context, "graze_motion_text", "out, context and motion must not be NULL");
    IN_ENVIRONMENT();
    text t;
    text_init(&t);
    motion_write(&t, motion);
    return text_finish(out, context, &t);
}
