/* Motions from parsed JSON: the choice of one of four forms, and motions made of other motions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/motion/draft.h"

#include "base/context/file.h"
#include "base/context/scope.h"

enum { DIMENSION, PIECES, KEYFRAMES, RELATIVE, SEQUENCE, KEYS };

static graze_status read_motion_dimension(int *out, graze_context *context, const json *value,
                                          int outer) {
    LOCAL(fmpz, number);
    TRY(entry_integer(number, context, value));
    if (fmpz_cmp_si(number, 2) != 0 && fmpz_cmp_si(number, 3) != 0)
        return json_fail(context, GRAZE_EINPUT, value, "the dimension is %.20s; expected 2 or 3",
                         value->text);
    *out = (int)fmpz_get_si(number);
    if (outer != 0 && *out != outer)
        return json_fail(context, GRAZE_EILLEGAL, value,
                         "this motion has dimension %d inside one of dimension %d", *out, outer);
    return GRAZE_OK;
}

/* Read a motion inside another one, and give every piece its map. */
static graze_status read_inner(draft *out, graze_context *context, const json *value,
                               int dimension) {
    TRY(motion_read_draft(out, context, value, dimension));
    return json_at_last(context, draft_spread(out, context), value);
}

static int same_interval(const draft *a, const draft *b) {
    return fmpq_equal(a->piece[0].lo, b->piece[0].lo) &&
           fmpq_equal(a->piece[a->count - 1].hi, b->piece[b->count - 1].hi);
}

static graze_status read_relative(draft *out, graze_context *context, const json *value) {
    static const char *const names[] = {"moving", "frame"};
    const json *member[2];
    TRY(json_members(member, context, value, names, 2));
    for (int k = 0; k < 2; k++)
        if (member[k] == NULL)
            return json_fail(context, GRAZE_EINPUT, value, "the key %s is missing", names[k]);
    HELD(draft, moving, out->dimension);
    HELD(draft, frame, out->dimension);
    TRY(read_inner(&moving, context, member[0], out->dimension));
    TRY(read_inner(&frame, context, member[1], out->dimension));
    if (!same_interval(&moving, &frame))
        return json_fail(
            context, GRAZE_EILLEGAL, value,
            "moving and frame have different intervals of t; expected the same interval");
    return json_at(context, draft_relative(out, context, &moving, &frame), value);
}

static int starts_at_identity(const draft *d) {
    LOCAL(fmpq, zero);
    HELD(affine, start, d->dimension);
    HELD(affine, identity, d->dimension);
    affine_at_time(&start, &d->piece[0].map, zero);
    return affine_equal(&start, &identity);
}

static graze_status read_sequence(draft *out, graze_context *context, const json *value) {
    TRY(json_array(context, value, 0));
    if (value->count == 0)
        return json_fail(context, GRAZE_EINPUT, value, "expected at least one motion");
    HELD(affine, end, out->dimension);
    for (const json *item = value->first; item != NULL; item = item->next) {
        HELD(draft, next, out->dimension);
        TRY(read_inner(&next, context, item, out->dimension));
        if (item->index > 0 && !starts_at_identity(&next))
            return json_fail(context, GRAZE_EILLEGAL, item,
                             "the motion jumps at t = %zu: expected every motion of a sequence "
                             "but the first to start at the identity",
                             item->index);
        TRY(json_at(context, draft_follow(out, context, &next, (slong)item->index, &end), item));
    }
    return GRAZE_OK;
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
    if (status == GRAZE_OK)
        status = context_in(context, draft_finish(out, context, &made), source, 0);
    json_clear(&document);
    return status;
}

graze_status motion_from_file(graze_motion **out, graze_context *context, const char *path) {
    FREED(char, text, NULL);
    size_t length;
    unsigned char sha256[32];
    *out = NULL;
    TRY(file_read(&text, &length, sha256, context, path));
    TRY(read_motion(out, context, path, text, length));
    memcpy((*out)->sha256, sha256, sizeof sha256);
    return GRAZE_OK;
}

graze_status motion_from_text(graze_motion **out, graze_context *context, const char *text,
                              size_t length) {
    TRY(read_motion(out, context, "motion", text, length));
    file_sha256((*out)->sha256, text, length);
    return GRAZE_OK;
}
