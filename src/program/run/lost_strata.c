/* Why strata have no points, and what helps.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/run/lost_strata.h"

#include <string.h>
#include "base/number/text.h"

graze_status lost_strata_dyadic(lost_strata *lost, const loaded *l, const scene_options *o,
                                unsigned long long seed, const unsigned long *weights) {
    graze_context *context = l->context;
    graze_motion *motion = NULL;
    graze_scene *scene = NULL;
    graze_generator *generator = NULL;
    char *json = NULL;
    graze_options options = o->scene;
    mpq_t tolerance;
    options.size = sizeof options;
    mpq_init(tolerance);
    mpq_set_ui(tolerance, 1, 1u << 20);
    graze_status status = graze_motion_write_dyadic(&json, NULL, context, l->motion, tolerance);
    if (!status)
        status = graze_motion_from_json(&motion, context, json, strlen(json));
    if (!status)
        status = graze_scene_create(&scene, context, l->solid, motion, &options);
    if (!status)
        status = graze_generator_create(&generator, context, scene, seed, weights,
                                        GRAZE_GENERATE_REPRESENTABLE);
    for (int k = 0; k < GRAZE_STRATUM_COUNT && !status; k++)
        lost->has_dyadic |=
            lost->unrepresentable >> k & 1 && graze_generator_weight(generator, (graze_stratum)k);
    graze_generator_destroy(generator);
    graze_scene_destroy(scene);
    graze_motion_destroy(motion);
    graze_free(json);
    mpq_clear(tolerance);
    /* A motion near this one that is not legal, or has no points at all, is no help. */
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

char *lost_strata_text(const lost_strata *lost) {
    text t;
    text_init(&t);
    text_put(&t, "");
    if (lost->unrepresentable) {
        text_put(&t, "no points of the strata ");
        put_stratum_names(&t, lost->unrepresentable);
        text_put(&t, " have coordinates that a binary64 holds, since numbers of the motion (or of "
                     "the solid) are not dyadic or too long");
        text_put(&t, lost->has_dyadic ? "; `graze motion dyadic` makes a motion near this one that "
                                        "has such points"
                                      : "");
        text_put(&t,
                 lost->replaced
                     ? "; `rounded` has their weight: points within an ulp of such contacts, on "
                       "both sides"
                 : lost->has_dyadic ? ""
                                    : "; the stratum `rounded` has points within an ulp of "
                                      "such contacts, on both sides");
    }
    if (lost->absent) {
        text_put(&t, lost->unrepresentable ? "; the scene has none of "
                                           : "the scene has no points of the strata ");
        put_stratum_names(&t, lost->absent);
    }
    if (lost->spent) {
        text_put(&t, lost->unrepresentable | lost->absent ? "; " : "");
        text_put(&t, "the strata ");
        put_stratum_names(&t, lost->spent);
        text_put(&t, " have fewer points than their weights ask for, as no others were found");
    }
    return text_take(&t);
}
