/* Motions from files and texts, and values of point maps.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdlib.h>
#include "context/file.h"
#include "motion/affine.h"
#include "motion/motion_read.h"

static graze_status read_text(graze_motion **out, graze_context *context, const char *source,
                              const char *text, size_t length) {
    json_document document;
    draft made;
    draft_init(&made, 0);
    *out = NULL;
    context->work = 0;
    graze_status status = json_parse(&document, context, source, text, length);
    if (status == GRAZE_OK) {
        status = motion_read_draft(&made, context, document.root, 0);
    }
    if (status == GRAZE_OK) {
        status = draft_finish(out, context, &made);
        if (status != GRAZE_OK) {
            context_at(context, status, "%s", source);
        }
    }
    draft_clear(&made);
    json_clear(&document);
    return status;
}

graze_status motion_from_file(graze_motion **out, graze_context *context, const char *path) {
    char *text;
    size_t length;
    unsigned char sha256[32];
    *out = NULL;
    graze_status status = file_read(&text, &length, sha256, context, path);
    if (status != GRAZE_OK) {
        return status;
    }
    status = read_text(out, context, path, text, length);
    free(text);
    for (int k = 0; k < 32 && *out != NULL; k++) {
        (*out)->sha256[k] = sha256[k];
    }
    return status;
}

graze_status motion_from_text(graze_motion **out, graze_context *context, const char *text,
                              size_t length) {
    graze_status status = read_text(out, context, "motion", text, length);
    if (status == GRAZE_OK) {
        file_sha256((*out)->sha256, text, length);
    }
    return status;
}

void motion_destroy(graze_motion *motion) {
    for (size_t k = 0; k < motion->piece_count; k++) {
        fmpq_clear(motion->piece[k].lo);
        fmpq_clear(motion->piece[k].hi);
        point_map_clear(&motion->piece[k].forward);
        point_map_clear(&motion->piece[k].inverse);
    }
    free(motion->piece);
    free(motion);
}

const point_map *motion_tracing(const motion_piece *piece, graze_operation operation) {
    return operation == GRAZE_UNSWEEP ? &piece->forward : &piece->inverse;
}

const point_map *motion_placing(const motion_piece *piece, graze_operation operation) {
    return operation == GRAZE_UNSWEEP ? &piece->inverse : &piece->forward;
}

void point_map_at(fmpq *out, const point_map *map, const fmpq_t u) {
    fmpq_t weight;
    fmpq_init(weight);
    fmpz_poly_evaluate_fmpq(weight, map->weight, u);
    for (int k = 0; k < map->dimension * (map->dimension + 1); k++) {
        fmpz_poly_evaluate_fmpq(&out[k], &map->entry[k], u);
        fmpq_div(&out[k], &out[k], weight);
    }
    fmpq_clear(weight);
}
