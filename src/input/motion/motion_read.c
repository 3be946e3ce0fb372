/* Motions from parsed JSON: the four forms, and those made of other motions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/motion/motion.h"

#include <stdlib.h>
#include "base/context/file.h"
#include "base/context/scope.h"
#include "input/motion/affine.h"
#include "input/motion/draft.h"

enum { DIMENSION, PIECES, KEYFRAMES, RELATIVE, SEQUENCE, KEYS };

static graze_status read_motion_dimension(int *out, graze_context *context, const json *value,
                                          int outer) {
    LOCAL(fmpz, number);
    graze_status status = entry_integer(number, context, value);
    if (status == GRAZE_OK && fmpz_cmp_si(number, 2) != 0 && fmpz_cmp_si(number, 3) != 0)
        status = json_fail(context, GRAZE_EINPUT, value, "the dimension is %.20s; expected 2 or 3",
                           value->text);
    if (status == GRAZE_OK) {
        *out = (int)fmpz_get_si(number);
        if (outer != 0 && *out != outer)
            status =
                json_fail(context, GRAZE_EILLEGAL, value,
                          "this motion has dimension %d inside one of dimension %d", *out, outer);
    }
    return status;
}

/* A motion inside another one, every piece with its map. */
static graze_status read_inner(draft *out, graze_context *context, const json *value,
                               int dimension) {
    graze_status status = motion_read_draft(out, context, value, dimension);
    if (status == GRAZE_OK) {
        status = draft_spread(out, context);
        json_at_last(context, status, value);
    }
    return status;
}

static int same_interval(const draft *a, const draft *b) {
    return fmpq_equal(a->piece[0].lo, b->piece[0].lo) &&
           fmpq_equal(a->piece[a->count - 1].hi, b->piece[b->count - 1].hi);
}

static graze_status read_relative(draft *out, graze_context *context, const json *value) {
    static const char *const names[] = {"moving", "frame"};
    const json *member[2];
    graze_status status = json_members(member, context, value, names, 2);
    for (int k = 0; k < 2 && status == GRAZE_OK; k++)
        if (member[k] == NULL)
            status = json_fail(context, GRAZE_EINPUT, value, "the key %s is missing", names[k]);
    if (status != GRAZE_OK)
        return status;
    draft moving;
    HELD(draft, frame, out->dimension);
    status = read_inner(&moving, context, member[0], out->dimension);
    if (status == GRAZE_OK)
        status = read_inner(&frame, context, member[1], out->dimension);
    if (status == GRAZE_OK && !same_interval(&moving, &frame)) {
        status =
            json_fail(context, GRAZE_EILLEGAL, value,
                      "moving and frame have different intervals of t; expected the same interval");
    } else if (status == GRAZE_OK) {
        status = draft_relative(out, context, &moving, &frame);
        if (status != GRAZE_OK)
            json_at(context, status, value);
    }
    draft_clear(&moving);
    return status;
}

static int starts_at_identity(const draft *d) {
    LOCAL(fmpq, zero);
    HELD(affine, start, d->dimension);
    HELD(affine, identity, d->dimension);
    affine_at_time(&start, &d->piece[0].map, zero);
    return affine_equal(&start, &identity);
}

static graze_status read_sequence(draft *out, graze_context *context, const json *value) {
    graze_status status = json_array(context, value, 0);
    if (status == GRAZE_OK && value->count == 0)
        status = json_fail(context, GRAZE_EINPUT, value, "expected at least one motion");
    HELD(affine, end, out->dimension);
    for (const json *item = value->first; item != NULL && status == GRAZE_OK; item = item->next) {
        draft next;
        status = read_inner(&next, context, item, out->dimension);
        if (status == GRAZE_OK && item->index > 0 && !starts_at_identity(&next)) {
            status = json_fail(context, GRAZE_EILLEGAL, item,
                               "the motion jumps at t = %zu: expected every motion of a sequence "
                               "but the first to start at the identity",
                               item->index);
        } else if (status == GRAZE_OK) {
            status = draft_follow(out, context, &next, (slong)item->index, &end);
            if (status != GRAZE_OK)
                json_at(context, status, item);
        }
        draft_clear(&next);
    }
    return status;
}

graze_status motion_read_draft(draft *out, graze_context *context, const json *value,
                               int dimension) {
    static const char *const names[KEYS] = {[DIMENSION] = "dimension",
                                            [PIECES] = "pieces",
                                            [KEYFRAMES] = "keyframes",
                                            [RELATIVE] = "relative",
                                            [SEQUENCE] = "sequence"};
    static graze_status (*const read[KEYS])(draft *, graze_context *,
                                            const json *) = {[PIECES] = motion_read_pieces,
                                                             [KEYFRAMES] = motion_read_keyframes,
                                                             [RELATIVE] = read_relative,
                                                             [SEQUENCE] = read_sequence};
    const json *member[KEYS];
    int form = 0, forms = 0, own = 0;
    draft_init(out, dimension);
    TRY(json_members(member, context, value, names, KEYS));
    if (member[DIMENSION] == NULL)
        return json_fail(context, GRAZE_EINPUT, value, "the key dimension is missing");
    for (int k = PIECES; k < KEYS; k++) {
        forms += member[k] != NULL;
        form = member[k] != NULL ? k : form;
    }
    if (forms != 1)
        return json_fail(context, GRAZE_EINPUT, value,
                         "expected exactly one of pieces, keyframes, relative, sequence, not %d",
                         forms);
    TRY(read_motion_dimension(&own, context, member[DIMENSION], dimension));
    out->dimension = own;
    return read[form](out, context, member[form]);
}

static graze_status read_motion(graze_motion **out, graze_context *context, const char *source,
                                const char *text, size_t length) {
    json_document document;
    HELD(draft, made, 0);
    *out = NULL;
    context->work = 0;
    graze_status status = json_parse(&document, context, source, text, length);
    if (status == GRAZE_OK)
        status = motion_read_draft(&made, context, document.root, 0);
    if (status == GRAZE_OK) {
        status = draft_finish(out, context, &made);
        if (status != GRAZE_OK)
            context_in(context, status, source, 0);
    }
    json_clear(&document);
    return status;
}

graze_status motion_from_file(graze_motion **out, graze_context *context, const char *path) {
    char *text;
    size_t length;
    unsigned char sha256[32];
    *out = NULL;
    graze_status status = file_read(&text, &length, sha256, context, path);
    if (status != GRAZE_OK)
        return status;
    status = read_motion(out, context, path, text, length);
    free(text);
    for (int k = 0; k < 32 && *out != NULL; k++)
        (*out)->sha256[k] = sha256[k];
    return status;
}

graze_status motion_from_text(graze_motion **out, graze_context *context, const char *text,
                              size_t length) {
    TRY(read_motion(out, context, "motion", text, length));
    file_sha256((*out)->sha256, text, length);
    return GRAZE_OK;
}
