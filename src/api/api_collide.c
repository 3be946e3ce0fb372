/* The public functions of pairs. SPDX-License-Identifier: GPL-3.0-or-later */
#include "api/api.h"

#include <stdlib.h>
#include <string.h>
#include "base/context/scope.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "output/report/report.h"
#include "questions/collide/collide.h"

static const char name[] = "graze_pair_create";

static graze_status check_pair_solids(graze_context *context, const graze_solid *moving,
                                      const graze_motion *motion, const graze_solid *fixed) {
    if (moving->curved || fixed->curved)
        return api_curved(context, name);
    if (moving->input.dimension != motion->dimension || fixed->input.dimension != motion->dimension)
        return context_fail(context, GRAZE_EILLEGAL,
                            "the moving solid, the motion and the fixed solid have dimensions %d, "
                            "%d and %d; expected one dimension",
                            moving->input.dimension, motion->dimension, fixed->input.dimension);
    return GRAZE_OK;
}

static graze_status check_pair_options(graze_pair_options *out, graze_context *context,
                                       const graze_pair_options *options) {
    TRY(api_options(out, sizeof *out, context, name, options));
    if ((unsigned)out->question > GRAZE_PAIR_INSIDE)
        return api_misuse(context, name, "there is no such question");
    if (out->first != 0 && out->first != 1)
        return api_misuse(context, name, "options.first must be 0 or 1");
    return GRAZE_OK;
}

graze_status graze_pair_create(graze_pair **out, graze_context *context, const graze_solid *moving,
                               const graze_motion *motion, const graze_solid *fixed,
                               const graze_motion *motion_of_fixed,
                               const graze_pair_options *options) {
    if (out)
        *out = NULL;
    if (!out || !context || !moving || !motion || !fixed)
        return api_misuse(context, name, "out, context, moving, motion and fixed must not be NULL");
    IN_ENVIRONMENT();
    graze_pair_options checked;
    graze_status status = check_pair_options(&checked, context, options);
    if (!status)
        status = check_pair_solids(context, moving, motion, fixed);
    graze_pair *made = status ? NULL : calloc(1, sizeof *made);
    if (!made)
        return status ? status : context_fail(context, GRAZE_ESYSTEM, "out of memory");
    made->options = checked;
    made->pair = (solid_pair){.moving = moving, .fixed = fixed, .motion = motion};
    if (motion_of_fixed) {
        status = motion_relative(&made->own, context, motion, motion_of_fixed);
        made->pair.motion = made->own;
    }
    if (!status)
        status = collide_answer(made, context);
    if (status)
        graze_pair_destroy(made);
    else
        *out = made;
    return status;
}

void graze_pair_destroy(graze_pair *pair) {
    if (!pair)
        return;
    collide_clear(pair);
    free(pair);
}

graze_pair_verdict graze_pair_get_verdict(const graze_pair *pair) {
    return pair ? collide_verdict(pair) : GRAZE_PAIR_NONE;
}

const char *graze_pair_word(const graze_pair *pair) {
    return pair ? pair->walk.word : "";
}

graze_state graze_pair_next(const graze_pair *pair) {
    return pair ? collide_next(pair) : GRAZE_STATE_ABSENT;
}

size_t graze_pair_contact_count(const graze_pair *pair) {
    return pair ? pair->walk.contact_count : 0;
}

graze_pair_contact graze_pair_get_contact(const graze_pair *pair, size_t index) {
    graze_pair_contact out;
    memset(&out, 0, sizeof out);
    if (index >= graze_pair_contact_count(pair))
        return out;
    const pair_contact *c = &pair->walk.contact[index];
    out.from = c->from;
    out.cells = c->cells.item;
    out.cell_count = c->cells.count;
    if (pair->options.first)
        return out;
    out.kind = verdict_kind(c->left, c->right);
    out.left = c->left;
    out.right = c->right;
    out.to = c->to;
    return out;
}

const graze_time *graze_pair_overlap_time(const graze_pair *pair) {
    return pair ? collide_overlap_time(pair) : NULL;
}

const char *graze_pair_verdict_name(graze_pair_verdict verdict) {
    return pair_verdict_name(verdict);
}

const char *graze_cell_pair_name(const graze_cell_pair *cells) {
    return cells ? cell_pair_name(cells) : "";
}

/* Give a pair as a text that `write` makes, for the public function `caller`. */
static graze_status pair_written(char **out, graze_context *context, const graze_pair *pair,
                                 const char *caller, void (*write)(text *, const graze_pair *)) {
    if (out)
        *out = NULL;
    if (!out || !context || !pair)
        return api_misuse(context, caller, "out, context and pair must not be NULL");
    IN_ENVIRONMENT();
    text t;
    text_init(&t);
    write(&t, pair);
    return text_finish(out, context, &t);
}

graze_status graze_pair_text(char **out, graze_context *context, const graze_pair *pair) {
    return pair_written(out, context, pair, "graze_pair_text", pair_text);
}

graze_status graze_pair_json(char **out, graze_context *context, const graze_pair *pair) {
    return pair_written(out, context, pair, "graze_pair_json", pair_json);
}
