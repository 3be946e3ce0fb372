/* The public functions of comparisons: argument checks and one call each.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include <stdlib.h>
#include <string.h>
#include "base/context/scope.h"
#include "decide/filter/filter.h"
#include "output/compare/compare.h"

static int compare_options_known(const graze_compare_options *o) {
    return (unsigned)o->question <= GRAZE_QUESTION_CLOSED &&
           (unsigned)o->on_as <= GRAZE_ON_AS_OUT && (unsigned)o->has <= GRAZE_HAS_SDF &&
           (unsigned)o->truth <= GRAZE_TRUTH_OUTSIDE;
}

graze_status graze_compare(graze_comparison **out, graze_context *context, const char *golden,
                           const char *candidate, const graze_compare_options *options) {
    if (out)
        *out = NULL;
    if (!out || !context || !golden || !candidate)
        return api_misuse(context, "graze_compare",
                          "out, context, golden and candidate must not be NULL");
    graze_compare_options taken;
    graze_status status = api_options(&taken, sizeof taken, context, "graze_compare", options);
    if (status)
        return status;
    if (!compare_options_known(&taken))
        return api_misuse(context, "graze_compare", "an option has an unknown value");
    if (taken.has != GRAZE_HAS_SDF && (taken.truth || taken.sdf_tolerance))
        return api_misuse(context, "graze_compare",
                          "truth and sdf_tolerance are of the column sdf; expected has to be "
                          "GRAZE_HAS_SDF");
    IN_ENVIRONMENT();
    graze_comparison *c = calloc(1, sizeof *c);
    if (!c)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory");
    status = comparison_make(c, context, golden, candidate, &taken);
    if (status)
        graze_comparison_destroy(c);
    else
        *out = c;
    return status;
}

void graze_comparison_destroy(graze_comparison *comparison) {
    if (comparison)
        comparison_clear(comparison);
    free(comparison);
}

graze_comparison_counts graze_comparison_count(const graze_comparison *comparison) {
    graze_comparison_counts counts = {0};
    if (!comparison)
        return counts;
    counts.rows = comparison->rows;
    counts.agree = comparison->agree;
    counts.wrong = comparison->wrong;
    counts.undecided = comparison->undecided;
    counts.missing = comparison->missing;
    counts.extra = comparison->extra;
    memcpy(counts.wrong_as, comparison->wrong_as, sizeof counts.wrong_as);
    counts.has_no_on = comparison_has_no_on(comparison);
    return counts;
}

graze_disagreement graze_comparison_disagreement(const graze_comparison *comparison, size_t index) {
    graze_disagreement out = {0, 0, 0, NULL, NULL, NULL};
    if (!comparison || index >= comparison->shown)
        return out;
    const disagreement *d = &comparison->disagreements[index];
    return (graze_disagreement){d->row,   d->golden_line, d->candidate_line,
                                d->point, d->golden,      d->candidate};
}

const char *graze_comparison_head(const graze_comparison *comparison) {
    return comparison ? comparison->explain_options : "";
}

graze_status graze_comparison_report(char **out, graze_context *context,
                                     const graze_comparison *comparison,
                                     graze_comparison_format format) {
    if (out)
        *out = NULL;
    if (!out || !context || !comparison)
        return api_misuse(context, "graze_comparison_report",
                          "out, context and comparison must not be NULL");
    if (format == GRAZE_COMPARISON_TEXT)
        return comparison_text(out, context, comparison);
    if (format == GRAZE_COMPARISON_JSON)
        return comparison_json(out, context, comparison);
    return api_misuse(context, "graze_comparison_report",
                      "there is no such format; expected text or JSON");
}
