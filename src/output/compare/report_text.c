/* Reports of comparisons as Markdown.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/compare/judgement.h"

#include <stdlib.h>
#include <string.h>

const char *truth_name(const graze_comparison *c) {
    return c->options.truth == GRAZE_TRUTH_OUTSIDE ? "outside" : "pseudo";
}

unsigned long values_within(const errors *e) {
    return e->rows - e->over - e->under;
}

/* Append a word for the shell, quoted if it has other than plain characters. */
static void put_word(text *out, const char *word) {
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                "_./-+:@%,=";
    if (*word && strspn(word, plain) == strlen(word)) {
        text_put(out, word);
        return;
    }
    text_put(out, "'");
    for (; *word; word++)
        text_put(out, *word == '\'' ? "'\\''" : (char[]){*word, '\0'});
    text_put(out, "'");
}

char *explain_command(const graze_comparison *c, const disagreement *d) {
    text command;
    text_init(&command);
    if (strstr(c->explain_options, " --at-rest")) {
        text_format(&command, "echo %s | graze classify ", d->point);
        put_word(&command, c->solid);
        text_format(&command, " -%s", c->explain_options);
        return text_take(&command);
    }
    text_put(&command, "graze explain ");
    put_word(&command, c->solid);
    text_put(&command, " ");
    put_word(&command, c->motion);
    text_format(&command, " %s%s", d->point, c->explain_options);
    return text_take(&command);
}

/* Many rows without a counterpart in both tables are a sign of rounded numbers. */
const char *comparison_hint(const graze_comparison *c) {
    unsigned long fewer = c->missing < c->extra ? c->missing : c->extra;
    int many = 20 * fewer >= c->rows && 2 * fewer >= c->missing && 2 * fewer >= c->extra;
    if (!fewer || !many || c->key.by_id)
        return NULL;
    return c->rounding == GRAZE_ROUND_NONE
               ? "many rows are missing and as many extra: the candidate's coordinates look "
                 "rounded; `--round binary64` rounds the golden ones too, and a column `id` in "
                 "both tables matches rows without coordinates"
               : "many rows are missing and as many extra, rounded too: the candidate's "
                 "coordinates are other numbers; 17 digits keep a binary64, and a column `id` in "
                 "both tables matches rows without coordinates";
}

/* A table's name, or a phrase for a table that is not kept. */
static const char *table_shown(const graze_comparison *c, const char *name) {
    return !c->options.transient ? name
           : c->shown            ? "made for this report and not kept; rows stand below"
                                 : "made for this report and not kept";
}

static void put_errors_head(text *out, const char *name) {
    text_format(out, "\n| %s | values | within | over | under | beyond |", name);
    for (int k = 0; k < QUANTILES; k++)
        text_format(out, " %s %% |", quantiles[k].name);
    text_put(out, " largest | largest over |\n|---|");
    for (int k = 0; k < 5 + QUANTILES + 2; k++)
        text_put(out, "--:|");
    text_put(out, "\n");
}

static void put_errors_line(text *out, const graze_comparison *c, const char *name,
                            const errors *e) {
    text_put(out, "| ");
    text_markdown(out, *name ? name : "-");
    text_format(out, " | %lu | %lu | %lu | %lu | ", e->rows, values_within(e), e->over, e->under);
    if (c->options.sdf_tolerance)
        text_format(out, "%lu |", e->beyond);
    else
        text_put(out, "- |");
    put_quantiles(out, e, QUANTILES);
    text_put(out, " ");
    ceiling_put(out, e->largest_over);
    text_put(out, " |\n");
}

static void put_values(text *out, const graze_comparison *c) {
    const graze_compare_options *o = &c->options;
    if (o->motion_error)
        text_format(out,
                    "motion error: %s; rows whose answer it leaves undecided: %lu; the candidate "
                    "has in %lu, on %lu, out %lu there\n",
                    o->motion_error, c->undecided_by_motion, c->undecided_answers[0],
                    c->undecided_answers[1], c->undecided_answers[2]);
    if (!c->valued)
        return;
    text_format(out, "values: sdf against the enclosures of the exact distance%s; truth: %s; ",
                o->motion_error ? ", widened by the motion error" : "", truth_name(c));
    if (o->sdf_tolerance)
        text_format(out, "beyond the tolerance %s: wrong\n", o->sdf_tolerance);
    else
        text_put(out, "not judged, without a tolerance\n");
    put_errors_head(out, "errors of sdf");
    put_errors_line(out, c, "all", &c->values);
}

static void put_values_by(text *out, const graze_comparison *c) {
    for (int by = 0; by < SHOWN_BY && c->valued; by++) {
        const tally *t = &c->tallies[by];
        if (!t->count)
            continue;
        text_format(out, "\nErrors of sdf by %s:\n", groupings[by].title);
        put_errors_head(out, column_name(groupings[by].of));
        for (size_t k = 0; k < t->count; k++)
            if (t->groups[k].values)
                put_errors_line(out, c, t->groups[k].name, t->groups[k].values);
        if (t->others.values)
            put_errors_line(out, c, "(others)", t->others.values);
    }
}

static void put_summary(text *out, const graze_comparison *c) {
    static const char *const on_as[] = {"an answer of its own", "right whatever is answered", "in",
                                        "out"};
    text_put(out, "golden: ");
    text_markdown(out, table_shown(c, c->golden));
    text_put(out, "\ncandidate: ");
    text_markdown(out, table_shown(c, c->candidate));
    text_put(out, "\n");
    if (c->contacts)
        put_sites(out, c);
    else
        text_format(out, "question: %s sweep; `on` counts as %s; rounding: %s\n",
                    c->options.question == GRAZE_QUESTION_CLOSED ? "closed" : "open",
                    on_as[c->options.on_as], graze_rounding_name(c->rounding));
    put_matched(out, c);
    text_put(out, "judged:");
    for (column j = COLUMN_X; j < COLUMN_OPTIONS; j++)
        if (c->judged[j])
            text_format(out, " %s", column_name(j));
    text_format(out, "%s\n\n",
                c->options.has == GRAZE_HAS_SDF ? " (from the sign of sdf, negative inside)" : "");
    text_format(
        out, "| rows | agree | wrong | missing | undecided | extra |\n|--:|--:|--:|--:|--:|--:|\n");
    text_format(out, "| %lu | %lu | %lu | %lu | %lu | %lu |\n\n", c->rows, c->agree, c->wrong,
                c->missing, c->undecided, c->extra);
    put_wrong_rows(out, c);
    if (comparison_hint(c))
        text_format(out, "hint: %s\n", comparison_hint(c));
    if (c->options.question == GRAZE_QUESTION_CLOSED)
        text_format(
            out,
            "undecided: `on` rows that may be seams, where the closed sweep goes on around the "
            "point; answered in %lu, on %lu, out %lu\n",
            c->undecided_answers[0], c->undecided_answers[1], c->undecided_answers[2]);
    if (c->open)
        text_format(out, "in %lu golden rows all answers that are judged are undecided\n", c->open);
    if (c->of_pmc)
        text_format(out, "in %lu golden rows class, i, t and word are undecided: pmc is judged\n",
                    c->of_pmc);
    put_values(out, c);
    put_sites_by_column(out, c);
}

static void put_matrix(text *out, const char *name, const char *const *words, int count,
                       const unsigned long *cells) {
    text_format(out, "\n| golden %s \\ candidate |", name);
    for (int k = 0; k < count; k++)
        text_format(out, " %s |", words[k]);
    text_put(out, " missing |\n|---|");
    for (int k = 0; k <= count; k++)
        text_put(out, "--:|");
    text_put(out, "\n");
    for (int r = 0; r < count; r++) {
        text_format(out, "| %s |", words[r]);
        for (int k = 0; k <= count; k++)
            text_format(out, " %lu |", cells[r * (count + 1) + k]);
        text_put(out, "\n");
    }
}

static void put_group(text *out, const char *name, const group *g) {
    if (!g->rows)
        return;
    text_put(out, "| ");
    text_markdown(out, *name ? name : "-");
    text_format(out, " | %lu | %lu | ", g->rows, g->wrong);
    put_share(out, g->wrong, g->rows);
    text_format(out, " | %lu | %lu |\n", g->missing, g->undecided);
}

static void put_tally(text *out, grouping by, const tally *t) {
    if (!t->count)
        return;
    text_format(
        out, "\n| %s | rows | wrong | share | missing | undecided |\n|---|--:|--:|--:|--:|--:|\n",
        groupings[by].title);
    for (size_t k = 0; k < t->count; k++)
        put_group(out, t->groups[k].name, &t->groups[k]);
    put_group(out, "(others)", &t->others);
}

/* Append the rows that disagree of one of two transient tables. */
static void put_side_rows(text *out, const graze_comparison *c, int candidate) {
    text_format(out, "\nRows of the %s:\n\n    %s\n", candidate ? "candidate" : "golden table",
                candidate ? c->candidate_columns : c->golden_columns);
    for (size_t k = 0; k < c->shown; k++) {
        const disagreement *d = &c->disagreements[k];
        const char *row = candidate ? d->candidate_row : d->golden_row;
        if (row)
            text_format(out, "    %s\n", row);
    }
}

static void put_disagreement(text *out, const graze_comparison *c, const disagreement *d) {
    if (d->golden && c->options.transient)
        text_put(out, "golden, ");
    else if (d->golden)
        text_format(out, "line %lu of the golden table, ", d->golden_line);
    text_markdown(out, d->golden ? d->golden : "no row of the golden table");
    if (d->candidate && c->options.transient)
        text_put(out, "\n   candidate, ");
    else if (d->candidate)
        text_format(out, "\n   candidate, line %lu, ", d->candidate_line);
    else
        text_put(out, "\n   candidate: ");
    text_markdown(out, d->candidate ? d->candidate : "no row");
    text_put(out, "\n   ");
    char *command = *d->point ? explain_command(c, d) : NULL;
    if (*d->point && !command)
        out->failed = 1;
    else
        text_code(out, command ? command : "(no point)");
    text_put(out, "\n");
    free(command);
}

static void put_disagreements(text *out, const graze_comparison *c) {
    const char *order = ", in the order of the tables, as the golden one has no sdf_low, sdf_high";
    if (c->by_depth)
        order = ", the deepest wrong rows first, at most two of a stratum";
    else if (c->contacts || c->depth.unmeasured)
        order = "";
    if (c->shown)
        text_format(out, "\nThe first %zu of %lu disagreements%s:\n", c->shown,
                    c->wrong + c->missing + c->extra, order);
    for (size_t k = 0; k < c->shown; k++) {
        const disagreement *d = &c->disagreements[k];
        text_format(out, "\n%zu. ", k + 1);
        put_disagreement(out, c, d);
    }
    for (int side = 0; side < 2 && c->shown && c->options.transient; side++)
        put_side_rows(out, c, side);
}

graze_status comparison_text(char **out, graze_context *context, const graze_comparison *c) {
    text bytes;
    text_init(&bytes);
    put_summary(&bytes, c);
    if (c->judged[COLUMN_PMC])
        put_matrix(&bytes, "pmc", pmc_words, 3, &c->confusion.pmc[0][0]);
    if (c->judged[COLUMN_CLASS])
        put_matrix(&bytes, "class", class_words, 5, &c->confusion.class_[0][0]);
    for (int g = 0; g < GROUPING_COUNT; g++)
        put_tally(&bytes, (grouping)g, &c->tallies[g]);
    put_values_by(&bytes, c);
    put_depths(&bytes, c);
    put_disagreements(&bytes, c);
    return text_finish(out, context, &bytes);
}
