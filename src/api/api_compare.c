/* The public functions of comparisons: argument checks and one call each.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include "output/compare/compare.h"

graze_status graze_compare(graze_comparison **out, graze_context *context, const char *golden,
                           const char *candidate, const graze_compare_options *options) {
    PUBLIC_OUT(out, context, golden, candidate);
    graze_compare_options taken;
    TRY(api_options(&taken, sizeof taken, context, __func__, options));
    REFUSED((unsigned)taken.question > GRAZE_QUESTION_CLOSED ||
                (unsigned)taken.on_as > GRAZE_ON_AS_OUT || (unsigned)taken.has > GRAZE_HAS_SDF ||
                (unsigned)taken.truth > GRAZE_TRUTH_OUTSIDE,
            "an option has an unknown value");
    REFUSED(taken.has != GRAZE_HAS_SDF && (taken.truth || taken.sdf_tolerance),
            "truth and sdf_tolerance are of the column sdf; expected has to be "
            "GRAZE_HAS_SDF");
    CREATE(out, made, graze_comparison_destroy,
           comparison_make(made, context, golden, candidate, &taken));
}

DESTROYER(graze_comparison, comparison_clear(of))

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

FACT(const char *, graze_comparison_head, graze_comparison, of->explain_options, "")

graze_status graze_comparison_report(char **out, graze_context *context,
                                     const graze_comparison *comparison,
                                     graze_comparison_format format) {
    PUBLIC_OUT(out, context, comparison);
    REFUSED((unsigned)format > GRAZE_COMPARISON_JSON,
            "there is no such format; expected text or JSON");
    return (format == GRAZE_COMPARISON_JSON ? comparison_json : comparison_text)(out, context,
                                                                                 comparison);
}
