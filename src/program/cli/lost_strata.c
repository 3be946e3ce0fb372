/* Messages on strata without points: the reason, and options that help.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "program/cli/values.h"

graze_status lost_strata_dyadic(lost_strata *lost, const loaded *l, const scene_options *o,
                                unsigned long long seed) {
    graze_context *context = l->context;
    OWNED(graze_motion, motion);
    OWNED(graze_scene, scene);
    OWNED(graze_generator, generator);
    FREED(char, json, NULL);
    unsigned long weights[GRAZE_STRATUM_COUNT];
    graze_options options = o->scene;
    options.size = sizeof options;
    LOCAL(mpq, tolerance);
    mpq_set_ui(tolerance, 1, 1u << 20);
    graze_status status = graze_motion_write_dyadic(&json, NULL, context, l->motion, tolerance);
    if (!status)
        status = graze_motion_from_json(&motion, context, json, strlen(json));
    if (!status)
        status = graze_scene_create(&scene, context, l->solid, motion, &options);
    for (int k = 0; k < GRAZE_STRATUM_COUNT; k++)
        weights[k] = lost->unrepresentable >> k & 1;
    if (!status)
        status = graze_generator_create(&generator, context, scene, seed, weights,
                                        GRAZE_GENERATE_REPRESENTABLE);
    lost->has_dyadic = !status;
    /* Other failures mean that the dyadic motion is not legal or has no points: has_dyadic is 0. */
    return status == GRAZE_ECANCELED || status == GRAZE_ESYSTEM ? status : GRAZE_OK;
}

static void put_stratum_names(text *t, unsigned set) {
    const char *before = "";
    for (int k = 0; k < GRAZE_STRATUM_COUNT; k++)
        if (set >> k & 1) {
            text_format(t, "%s%s", before, graze_stratum_name((graze_stratum)k));
            before = ", ";
        }
}

/* Append a line about a set of strata, unless it is empty. */
static void put_strata(text *t, const char *between, const char *before, unsigned set,
                       const char *behind) {
    if (!set)
        return;
    text_put(t, t->length ? between : "");
    text_put(t, before);
    put_stratum_names(t, set);
    text_put(t, behind);
}

char *lost_strata_text(const lost_strata *lost, const char *between) {
    text t;
    text_init(&t);
    text_put(&t, "");
    put_strata(&t, between, "no points of the strata ", lost->unrepresentable,
               " have coordinates that a binary64 holds: numbers of the motion or solid are not "
               "dyadic, or too long");
    if (lost->unrepresentable && lost->has_dyadic)
        text_format(&t, "%s`graze motion dyadic` makes a motion near this one that has such points",
                    between);
    if (lost->unrepresentable && (lost->replaced || !lost->has_dyadic))
        text_format(&t, "%s`rounded` has %spoints within an ulp of such contacts, on both sides",
                    between, lost->replaced ? "their weight: " : "");
    put_strata(&t, between, "the scene has no points of the strata ", lost->absent, "");
    put_strata(&t, between, "fewer points than their weights ask for were found of the strata ",
               lost->spent, "");
    return text_take(&t);
}
