/* The public functions of pairs. SPDX-License-Identifier: GPL-3.0-or-later */
#include "api/api.h"

#include <math.h>
#include "decide/verdict/verdict.h"
#include "output/report/report.h"
#include "questions/collide/collide.h"

static const char name[] = "graze_pair_create";

static graze_status check_pair_solids(graze_context *context, const graze_solid *moving,
                                      const graze_motion *motion, const graze_solid *fixed) {
    if (moving->input.dimension != motion->dimension || fixed->input.dimension != motion->dimension)
        return context_fail(context, GRAZE_EILLEGAL,
                            "the moving solid, the motion and the fixed solid have dimensions %d, "
                            "%d and %d; expected one dimension",
                            moving->input.dimension, motion->dimension, fixed->input.dimension);
    return GRAZE_OK;
}

static graze_status make_pair(graze_pair *made, graze_context *context,
                              const graze_pair_options *options, solid_pair pair,
                              const graze_motion *motion_of_fixed) {
    made->options = *options;
    made->pair = pair;
    made->frame = motion_of_fixed;
    fmpq_init(made->distance);
    fmpq_init(made->error);
    if (options->clearance)
        fmpq_set_mpq(made->distance, options->clearance);
    if (options->motion_error)
        fmpq_set_mpq(made->error, options->motion_error);
    made->is_bounded = options->motion_error != NULL;
    made->options.first |= made->is_bounded;
    fmpq_add(made->distance, made->distance, made->error);
    made->options.clearance = made->options.motion_error = NULL; /* borrowed for the call alone */
    if (motion_of_fixed) {
        TRY(motion_relative(&made->own, context, made->pair.motion, motion_of_fixed));
        made->pair.motion = made->own;
    }
    TRY(collide_set_clearance(made, context));
    if (options->closest > 0)
        TRY(collide_closest(made, context));
    TRY(collide_answer(made, context));
    return made->is_bounded ? collide_bound_first(made, context) : GRAZE_OK;
}

static graze_status check_pair_options(graze_pair_options *out, graze_context *context,
                                       const graze_pair_options *options) {
    TRY(api_options(out, sizeof *out, context, name, options));
    if ((unsigned)out->question > GRAZE_PAIR_INSIDE)
        return api_misuse(context, name, "the question has an unknown value");
    if (out->first != 0 && out->first != 1)
        return api_misuse(context, name, "options.first must be 0 or 1");
    if (!(out->closest >= 0 && isfinite(out->closest)))
        return api_misuse(context, name, "options.closest must be a positive finite width, or 0");
    if (out->closest_relative != 0 && out->closest_relative != 1)
        return api_misuse(context, name, "options.closest_relative must be 0 or 1");
    if (out->closest > 0 && (out->first || out->question == GRAZE_PAIR_INSIDE))
        return api_misuse(context, name, "the least distance goes without first and inside");
    if (out->motion_error && (out->first || out->closest > 0 || out->question == GRAZE_PAIR_INSIDE))
        return api_misuse(context, name, "a motion error goes without first, closest and inside");
    for (int k = 0; k < 2; k++) {
        mpq_srcptr length = k ? out->motion_error : out->clearance;
        if (length)
            TRY(api_rational_check(context, length));
        if (length && mpq_sgn(length) < 0)
            return api_misuse(context, name, "a clearance and a motion error are not negative");
    }
    return GRAZE_OK;
}

graze_status graze_pair_create(graze_pair **out, graze_context *context, const graze_solid *moving,
                               const graze_motion *motion, const graze_solid *fixed,
                               const graze_motion *motion_of_fixed,
                               const graze_pair_options *options) {
    PUBLIC_OUT(out, context, moving, motion, fixed);
    graze_pair_options checked;
    TRY(check_pair_options(&checked, context, options));
    TRY(check_pair_solids(context, moving, motion, fixed));
    CREATE(out, made, graze_pair_destroy,
           make_pair(made, context, &checked,
                     (solid_pair){.moving = moving, .fixed = fixed, .motion = motion},
                     motion_of_fixed));
}

DESTROYER(graze_pair, collide_clear(of))
FACT(graze_pair_verdict, graze_pair_get_verdict, graze_pair, collide_verdict(of), GRAZE_PAIR_NONE)
FACT(const char *, graze_pair_word, graze_pair, of->walk.word, "")
FACT(graze_state, graze_pair_next, graze_pair, collide_next(of), GRAZE_STATE_ABSENT)
FACT(size_t, graze_pair_contact_count, graze_pair, of->walk.contact_count, 0)

static const graze_closest no_closest;
static const graze_first_contact no_bounds;
FACT(graze_closest, graze_pair_get_closest, graze_pair, of->closest, no_closest)
FACT(graze_first_contact, graze_pair_get_first, graze_pair, of->bounds, no_bounds)

graze_pair_contact graze_pair_get_contact(const graze_pair *pair, size_t index) {
    graze_pair_contact out = {0};
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

FACT(const graze_time *, graze_pair_overlap_time, graze_pair, collide_overlap_time(of), NULL)

const char *graze_pair_verdict_name(graze_pair_verdict verdict) {
    return pair_verdict_name(verdict);
}

FACT(const char *, graze_cell_pair_name, graze_cell_pair, cell_pair_name(of), "")

graze_status graze_pair_text(char **out, graze_context *context, const graze_pair *pair) {
    PUBLIC_OUT(out, context, pair);
    HELD(text, t);
    pair_text(&t, pair);
    return text_finish(out, context, &t);
}

graze_status graze_pair_json(char **out, graze_context *context, const graze_pair *pair) {
    PUBLIC_OUT(out, context, pair);
    HELD(text, t);
    pair_json(&t, pair);
    return text_finish(out, context, &t);
}

graze_status graze_pair_fields(char **out, graze_context *context, const graze_pair *pair) {
    PUBLIC_OUT(out, context, pair);
    HELD(text, t);
    pair_fields(&t, pair);
    return text_finish(out, context, &t);
}
