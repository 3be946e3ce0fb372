/* The public functions of the generator.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include "questions/generate/generate.h"

const char *graze_stratum_name(graze_stratum stratum) {
    return stratum_name(stratum);
}

unsigned long graze_stratum_default_weight(graze_stratum stratum) {
    return stratum_weight(stratum);
}

graze_status graze_generator_create(graze_generator **out, graze_context *context,
                                    const graze_scene *scene, unsigned long long seed,
                                    const unsigned long *weights, unsigned flags) {
    PUBLIC_OUT(out, context, scene);
    REFUSED(flags == 2 || flags > GRAZE_GENERATE_ROUNDED, "an unknown flag is set");
    TRY(api_takes(context, "graze_generator_create", scene->solid));
    unsigned long chosen[GRAZE_STRATUM_COUNT];
    for (int k = 0; k < GRAZE_STRATUM_COUNT; k++) {
        chosen[k] = weights ? weights[k] : stratum_weight((graze_stratum)k);
        REFUSED(chosen[k] > 1000000, "a weight is more than 1000000");
    }
    graze_generator *made = malloc(sizeof *made);
    if (!made)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a generator");
    graze_status status = generator_make(made, context, scene, seed, chosen, flags);
    if (status)
        graze_generator_destroy(made);
    else
        *out = made;
    return status;
}

DESTROYER(graze_generator, generator_clear(of))

unsigned long graze_generator_weight(const graze_generator *generator, graze_stratum stratum) {
    return generator && stratum_name(stratum) ? generator->weight[stratum] : 0;
}

int graze_generator_is_unrepresentable(const graze_generator *generator, graze_stratum stratum) {
    return generator && stratum_name(stratum) && generator->unrepresentable >> stratum & 1;
}

int graze_generator_missing_decade(int *decade, int *outward, const graze_generator *generator,
                                   size_t index) {
    if (!decade || !outward || !generator || index >= generator->missing_count)
        return 0;
    *decade = generator->missing[index].decade;
    *outward = generator->missing[index].outward;
    return 1;
}

void graze_generator_box(mpq_t *low, mpq_t *high, const graze_generator *generator) {
    if (!low || !high || !generator)
        return;
    api_point_out(low, generator->low, generator->scene->motion->dimension);
    api_point_out(high, generator->high, generator->scene->motion->dimension);
}

graze_status graze_generator_point(mpq_t *point, mpq_t time, graze_sample *out,
                                   graze_context *context, const graze_generator *generator,
                                   unsigned long long row) {
    REFUSED(!point != !time || !out || !context || !generator, "no argument may be NULL");
    IN_ENVIRONMENT();
    HELD(sample, s);
    s.alone = !point && !generator->atlas;
    graze_status status = generator_sample(&s, context, generator, row);
    *out = s.made;
    if (!status && point)
        api_point_out(point, s.point, generator->scene->motion->dimension);
    if (point)
        fmpq_get_mpq(time, s.time);
    return status;
}
