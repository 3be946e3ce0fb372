/* The generator: its times, its strata and their weights, the point of a row.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/generate/charts.h"

#include "base/context/scope.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"
#include "questions/generate/strata.h"

/* INSTANTS is the number of times, at multiples of 2^-TIME_BITS of a piece; TRIES is the number of
 * tries for a stratum in one row; after TRIAL_ROWS trial rows without a point a stratum is given
 * up. */
enum { INSTANTS = 512, TIME_BITS = 10, TRIES = 200, TRIAL_ROWS = 24 };

/* Random streams of the trials and of the times; no row of a table uses them. */
static const uint64_t TRIAL_STREAM = UINT64_C(1) << 63, TIME_STREAM = UINT64_C(3) << 62;

/* Make times at random multiples of 2^-10 inside random pieces. The first eighth are multiples of
 * 1/4, so that even few tries find points with short coordinates. */
static graze_status make_instants(struct graze_generator *g, graze_context *context) {
    TRY(MAKE_ARRAY(context, g->instants, INSTANTS, "a list of %d times", INSTANTS));
    random_stream r;
    LOCAL(fmpq, u);
    random_seed(&r, g->seed, TIME_STREAM);
    for (int k = 0; k < INSTANTS; k++) {
        size_t piece = random_below(&r, g->scene->motion->piece_count);
        slong simple = 1 + (slong)random_below(&r, 3);
        slong fine = 1 + (slong)random_below(&r, (1u << TIME_BITS) - 1);
        if (k < INSTANTS / 8)
            fmpq_set_si(u, simple, 4);
        else
            fmpq_set_si(u, fine, 1u << TIME_BITS);
        instant_init(&g->instants[k], g->scene, piece, u);
        g->instant_count++;
        TRY(context_poll(context));
    }
    return GRAZE_OK;
}

/* List the start of every piece, and the end of the last one. */
static graze_status list_joints(struct graze_generator *g, graze_context *context) {
    size_t pieces = g->scene->motion->piece_count;
    TRY(MAKE_ARRAY(context, g->joints, pieces + 1, "%zu break points", pieces));
    LOCAL(fmpq, u);
    for (size_t k = 0; k < pieces; k++)
        instant_init(&g->joints[g->joint_count++], g->scene, k, u);
    fmpq_one(u);
    instant_init(&g->joints[g->joint_count++], g->scene, pieces - 1, u);
    return GRAZE_OK;
}

/* Drop a point that has no answer. Contacts that are not displaced were traced before and have one.
 */
static graze_status keep_decided(int *made, sample *out, graze_context *context,
                                 const struct graze_generator *g) {
    graze_verdict found = {.pmc = out->made.pmc};
    if (out->made.order && !out->made.k && out->made.stratum != GRAZE_STRATUM_ROUNDED)
        return GRAZE_OK;
    if (out->made.stratum != GRAZE_STRATUM_ROUNDED)
        TRY(classify_answer(&found, context, g->scene, (query_point){.rational = out->point},
                            TRACE_PMC));
    *made = found.pmc != GRAZE_PMC_UNDECIDED;
    out->undecided += !*made;
    return GRAZE_OK;
}

static graze_status try_row(int *made, sample *out, graze_context *context,
                            const struct graze_generator *g, graze_stratum stratum,
                            random_stream *r) {
    *made = 0;
    for (int k = 0; k < TRIES && !*made; k++) {
        if (stratum == GRAZE_STRATUM_LEVEL)
            TRY(level_try(made, out, context, g, r));
        else if (stratum == GRAZE_STRATUM_ROUNDED)
            TRY(rounded_try(made, out, context, g, r));
        else
            TRY(stratum_try(made, out, context, g, stratum, r));
        if (*made && g->atlas)
            TRY(keep_decided(made, out, context, g));
    }
    return GRAZE_OK;
}

/* Does a trial make a point of the stratum? */
static graze_status try_stratum(int *made, sample *s, graze_context *context,
                                struct graze_generator *g, graze_stratum stratum) {
    *made = 0;
    if (stratum == GRAZE_STRATUM_LEVEL && g->weight[stratum]) {
        TRY(levels_find(g, context));
        *made = g->level_count > 0;
        return GRAZE_OK;
    }
    for (uint64_t row = 0; row < TRIAL_ROWS && !*made && g->weight[stratum]; row++) {
        random_stream r;
        random_seed(&r, g->seed, TRIAL_STREAM + row);
        TRY(try_row(made, s, context, g, stratum, &r));
    }
    return GRAZE_OK;
}

/* Find out whether a stratum without points whose coordinates are doubles has others. */
static graze_status try_unrepresentable(sample *s, graze_context *context,
                                        struct graze_generator *g, graze_stratum stratum) {
    int made;
    g->representable = 0;
    graze_status status = try_stratum(&made, s, context, g, stratum);
    g->representable = 1;
    g->level_count = g->missing_count = 0; /* `level` is the stratum, or not yet tried */
    g->unrepresentable |= (unsigned)(!status && made) << stratum;
    return status;
}

/* Set the weight of strata that no trial makes to 0. */
static graze_status try_strata(struct graze_generator *g, graze_context *context, int rounds) {
    HELD(sample, s);
    for (int stratum = 0; stratum < GRAZE_STRATUM_COUNT; stratum++) {
        int made;
        s.unkept =
            g->representable && stratum == GRAZE_STRATUM_LEVEL; /* tries samples of its own */
        TRY(try_stratum(&made, &s, context, g, (graze_stratum)stratum));
        if (!made && s.unkept)
            TRY(try_unrepresentable(&s, context, g, (graze_stratum)stratum));
        if (rounds && g->unrepresentable >> stratum & 1)
            g->weight[GRAZE_STRATUM_ROUNDED] += g->weight[stratum];
        if (!made)
            g->weight[stratum] = 0;
        g->total += g->weight[stratum];
    }
    if (g->total == 0)
        return context_fail(context, GRAZE_EUSE,
                            "no stratum with a weight can be made for this scene; give weight to "
                            "`random` or to others");
    return context_poll(context);
}

/* Look for points of a curved solid, which has no signed distances. */
static graze_status survey_curved(struct graze_generator *g, graze_context *context) {
    g->weight[GRAZE_STRATUM_LEVEL] = 0;
    TRY(MAKE_ARRAY(context, g->atlas, 1, "a generator"));
    return atlas_make(g->atlas, context, g->scene->solid->curved, g->instants, g->instant_count);
}

graze_status generator_make(struct graze_generator *out, graze_context *context,
                            const graze_scene *scene, uint64_t seed, const unsigned long *weights,
                            unsigned flags) {
    memset(out, 0, sizeof *out);
    out->scene = scene;
    out->seed = seed;
    out->representable = flags != 0;
    memcpy(out->weight, weights, sizeof out->weight);
    out->low = _fmpq_vec_init(6);
    out->high = out->low + 3;
    TRY(scene_box(out->low, out->high, context, scene));
    TRY(list_joints(out, context));
    TRY(make_instants(out, context));
    TRY(scene->solid->curved ? survey_curved(out, context)
                             : specials_find(&out->special, context, scene));
    return try_strata(out, context, flags == GRAZE_GENERATE_ROUNDED);
}

void generator_clear(struct graze_generator *g) {
    _fmpq_vec_clear(g->low, 6);
    specials_clear(&g->special);
    for (size_t k = 0; k < g->instant_count; k++)
        instant_clear(&g->instants[k]);
    for (size_t k = 0; k < g->joint_count; k++)
        instant_clear(&g->joints[k]);
    if (g->atlas)
        atlas_clear(g->atlas);
    free(g->atlas);
    free(g->instants);
    free(g->joints);
}

static graze_stratum draw_stratum(const struct graze_generator *g, random_stream *r) {
    size_t place = random_below(r, g->total);
    int stratum = 0;
    for (; place >= g->weight[stratum]; stratum++)
        place -= g->weight[stratum];
    return (graze_stratum)stratum;
}

/* If the stratum that is drawn makes no point for this row, a stratum is drawn again; the loop
 * ends, as each stratum with a weight made a point in a trial.
 */
graze_status generator_sample(sample *out, graze_context *context, const struct graze_generator *g,
                              uint64_t row) {
    random_stream r;
    random_seed(&r, g->seed, row);
    out->undecided = 0;
    for (int made = 0; !made;)
        TRY(try_row(&made, out, context, g, draw_stratum(g, &r), &r));
    out->made.undecided = out->undecided;
    if (out->made.order == 0)
        fmpq_zero(out->time);
    return GRAZE_OK;
}
