/* Counts, disagreements kept and depths of a comparison.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/compare/counts.h"

#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"

graze_status comparison_no_memory(graze_context *context) {
    return context_fail(context, GRAZE_ESYSTEM, "out of memory");
}

static int copy_names(graze_comparison *c, const char *golden, const char *candidate) {
    c->golden = strdup(golden);
    c->candidate = strdup(candidate);
    c->solid = strdup(c->options.solid ? c->options.solid : "SOLID");
    c->motion = strdup(c->options.motion ? c->options.motion : "MOTION");
    return c->golden && c->candidate && c->solid && c->motion;
}

int comparison_begin(graze_comparison *c, const graze_context *context, const char *golden,
                     const char *candidate, const graze_compare_options *options) {
    if (options)
        c->options = *options;
    c->rounding = context->rounding;
    fmpq_init(c->tolerance);
    fmpq_init(c->eta);
    return copy_names(c, golden, candidate);
}

char comparison_count(graze_comparison *c, const judgement *j, int answered) {
    char what = !answered ? 'm' : j->any_wrong ? 'w' : j->undecided ? 'u' : 'a';
    c->rows++;
    c->missing += what == 'm';
    c->wrong += what == 'w';
    c->undecided += what == 'u';
    c->agree += what == 'a';
    for (int k = 0; answered && k < JUDGED_COUNT; k++)
        c->column_wrong[k] += (unsigned long)j->wrong[k];
    for (int k = 0; answered && k < CONVENTIONS; k++)
        c->wrong_as[k] += (unsigned long)j->wrong_as[k];
    return what;
}

graze_status comparison_keep(disagreement **out, graze_comparison *c, graze_context *context) {
    *out = NULL;
    if (c->shown == c->options.show)
        return GRAZE_OK;
    if (!array_reserve(&c->disagreements, &c->shown_capacity, c->shown + 1,
                       sizeof *c->disagreements))
        return comparison_no_memory(context);
    *out = &c->disagreements[c->shown++];
    memset(*out, 0, sizeof **out);
    return GRAZE_OK;
}

/* Put the enclosure of its point behind the golden answers of a disagreement. */
static graze_status show_depth(disagreement *d, graze_context *context, const graze_scene *scene) {
    depth_bounds found;
    text all;
    graze_status status = depth_enclose(&found, context, scene, d->point);
    if (status)
        return status;
    text_init(&all);
    text_format(&all, "%s sdf_low=%s sdf_high=%s", d->golden, found.low, found.high);
    free(d->golden);
    d->golden = NULL;
    return text_finish(&d->golden, context, &all);
}

graze_status comparison_measure(graze_comparison *c, graze_context *context) {
    const graze_scene *scene = c->options.scene;
    graze_status status = GRAZE_OK;
    if (!scene || c->enclosed || c->contacts)
        return GRAZE_OK;
    for (size_t k = 0; k < c->shown && k < MOST_MEASURED && !status; k++)
        if (c->disagreements[k].golden && c->disagreements[k].candidate)
            status = show_depth(&c->disagreements[k], context, scene);
    if (!status)
        status = depth_measure(&c->depth, context, scene);
    if (status != GRAZE_ELIMIT)
        return status;
    c->depth.unmeasured = strdup(graze_context_message(context));
    return c->depth.unmeasured ? GRAZE_OK : comparison_no_memory(context);
}

void comparison_clear(graze_comparison *c) {
    for (size_t k = 0; k < c->shown; k++) {
        free(c->disagreements[k].point);
        free(c->disagreements[k].golden);
        free(c->disagreements[k].candidate);
        free(c->disagreements[k].golden_row);
        free(c->disagreements[k].candidate_row);
    }
    for (int g = 0; g < GROUPING_COUNT; g++)
        tally_clear(&c->tallies[g]);
    errors_clear(&c->values);
    depth_clear(&c->depth);
    fmpq_clear(c->tolerance);
    fmpq_clear(c->eta);
    free(c->disagreements);
    free(c->explain_options);
    free(c->golden_columns);
    free(c->candidate_columns);
    free(c->golden);
    free(c->candidate);
    free(c->solid);
    free(c->motion);
}
