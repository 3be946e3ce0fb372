/* Checks that two tables go together and chooses columns.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/compare/compare.h"

#include <string.h>
#include "base/context/scope.h"
#include "decide/filter/filter.h"
#include "output/compare/counts.h"
#include "output/compare/judgement.h"
#include "output/compare/rows.h"

/* The golden column of each grouping. */
static const column by[GROUPING_COUNT] = {COLUMN_STRATUM, COLUMN_K,          COLUMN_SDF_LOW,
                                          COLUMN_CLASS,   COLUMN_DEFINITION, COLUMN_CASE,
                                          COLUMN_STATUS,  COLUMN_ROLE};

column grouping_column(grouping g) {
    return by[g];
}

const char *grouping_name(grouping g) {
    return g == BY_SDF ? "sdf" : column_name(by[g]);
}

const char *grouping_title(grouping g) {
    return g == BY_DISTANCE ? "k (distance 2^-k)"
           : g == BY_SDF    ? "sdf (the power of ten below its size)"
                            : grouping_name(g);
}

static graze_status check_golden(const table *t) {
    static const char *const pmc = "pmc";
    char meant[TABLE_MEANT] = "";
    if (t->where[COLUMN_PMC] >= 0 && t->dimension)
        return GRAZE_OK;
    if (t->where[COLUMN_PMC] < 0)
        table_meant(meant, t, &pmc, 1);
    return context_fail_in(t->in.context, GRAZE_EINPUT, t->in.name, 0,
                           "has no column %s; expected a table, which graze classify SOLID MOTION "
                           "POINTS writes%s",
                           t->where[COLUMN_PMC] < 0 ? "pmc" : "x or no column y", meant);
}

/* Check that both tables are of one scene and one set of options. */
static graze_status check_notes(const table *golden, const table *candidate) {
    static const note same[] = {NOTE_SOLID,     NOTE_MOTION, NOTE_SCENE,
                                NOTE_OPERATION, NOTE_FOLDS,  NOTE_DIMENSION};
    for (size_t k = 0; k < sizeof same / sizeof *same; k++) {
        const char *g = golden->notes[same[k]], *c = candidate->notes[same[k]];
        if (g && c && strcmp(g, "none") != 0 && strcmp(c, "none") != 0 && strcmp(g, c) != 0)
            return context_fail_in(golden->in.context, GRAZE_EINPUT, candidate->in.name, 0,
                                   "%s is %.64s, that of %s is %.64s; expected tables of one "
                                   "scene and one set of options",
                                   note_name(same[k]), c, golden->in.name, g);
    }
    return GRAZE_OK;
}

/* Choose the columns to judge: those that the candidate has and the golden table can judge. */
static graze_status choose_columns(graze_comparison *c, const table *golden,
                                   const table *candidate) {
    static const char *const answers[] = {"sdf", "pmc", "class", "word"};
    int sdf = c->options.has == GRAZE_HAS_SDF, any = 0;
    char meant[TABLE_MEANT];
    table_meant(meant, candidate, sdf ? answers : answers + 1, sdf ? 1 : 3);
    if (sdf && candidate->where[COLUMN_SDF] < 0)
        return context_fail_in(golden->in.context, GRAZE_EINPUT, candidate->in.name, 0,
                               "has no column sdf; expected a signed distance in a column of that "
                               "name%s",
                               meant);
    for (const column *j = judged_columns; *j != COLUMN_COUNT; j++) {
        if (!judged_of(*j, 0) || *j == COLUMN_SDF)
            continue;
        int answered = candidate->where[*j] >= 0;
        int open = c->options.question == GRAZE_QUESTION_OPEN && !c->options.motion_error;
        c->judged[*j] = *j == COLUMN_PMC ? answered || sdf : answered && open && !sdf;
        if (c->judged[*j] && golden->where[*j] < 0)
            return context_fail_in(golden->in.context, GRAZE_EINPUT, golden->in.name, 0,
                                   "has no column %s; expected one to judge that of %s by",
                                   column_name(*j), candidate->in.name);
        any |= c->judged[*j];
    }
    if (!any)
        return context_fail_in(golden->in.context, GRAZE_EINPUT, candidate->in.name, 0,
                               "has no column that can be judged; expected one of %s%s",
                               c->options.question == GRAZE_QUESTION_OPEN &&
                                       !c->options.motion_error
                                   ? "pmc, class, i, t, word"
                                   : "pmc (or sdf)",
                               meant);
    return values_choose(c, golden);
}

/* Take over from the golden table the options of `graze explain`. */
static graze_status note_options(graze_comparison *c, graze_context *context, const table *t) {
    text options;
    const char *round = t->notes[NOTE_ROUND], *folds = t->notes[NOTE_FOLDS];
    const char *operation = t->notes[NOTE_OPERATION], *cut = t->notes[NOTE_TRIANGULATE];
    text_init(&options);
    if (round && (strcmp(round, graze_rounding_name(GRAZE_ROUND_BINARY64)) == 0 ||
                  strcmp(round, graze_rounding_name(GRAZE_ROUND_BINARY32)) == 0))
        text_format(&options, " --round %s", round);
    if (folds && strcmp(folds, "combined") == 0)
        text_put(&options, " --folds combined");
    if (operation && strcmp(operation, "unsweep") == 0)
        text_put(&options, " --operation unsweep");
    if (cut && strcmp(cut, "yes") == 0)
        text_put(&options, " --triangulate");
    return text_finish(&c->explain_options, context, &options);
}

graze_status comparison_choose(graze_comparison *c, const table *golden, const table *candidate) {
    TRY(sites_known(&c->contacts, golden, candidate));
    if (!c->contacts)
        TRY(check_golden(golden));
    TRY(check_notes(golden, candidate));
    TRY((c->contacts ? sites_choose : choose_columns)(c, golden, candidate));
    TRY(key_choose(&c->key, golden, candidate, c->contacts));
    return note_options(c, golden->in.context, golden);
}

int grouping_is_of(const graze_comparison *c, const table *golden, grouping g) {
    if (g == BY_SDF)
        return c->enclosed;
    int of_contacts = g == BY_STATUS || g == BY_ROLE, of_both = g == BY_STRATUM || g == BY_DISTANCE;
    return golden->where[grouping_column(g)] >= 0 && (of_both || of_contacts == c->contacts);
}
