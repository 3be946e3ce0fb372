/* Reports of comparisons as Markdown.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "compare/text.h"

#include <string.h>
#include "compare/judge.h"

const char *grouping_name(grouping g) {
    static const char *const names[GROUPING_COUNT] = {"stratum", "k", "class", "definition",
                                                      "case"};
    return names[g];
}

/* A word for the shell; quoted where it holds more than plain characters. */
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
    text_put(&command, "graze explain ");
    put_word(&command, c->solid);
    text_put(&command, " ");
    put_word(&command, c->motion);
    text_format(&command, " %s%s", d->point, c->explain_options);
    return text_take(&command);
}

/* A share with two digits, rounded to nearest, from whole numbers: it does not depend on the
 * locale. */
static void put_share(text *out, unsigned long part, unsigned long whole) {
    unsigned long long hundredths = whole ? (20000ull * part + whole) / (2ull * whole) : 0;
    text_format(out, "%llu.%02llu %%", hundredths / 100, hundredths % 100);
}

static void put_summary(text *out, const graze_comparison *c) {
    static const char *const on_as[] = {"an answer of its own", "right whatever is answered", "in",
                                        "out"};
    text_format(out, "golden: %s\ncandidate: %s\n", c->golden, c->candidate);
    text_format(out, "question: %s sweep; `on` counts as %s; rounding: %s\njudged:",
                c->options.question == GRAZE_QUESTION_CLOSED ? "closed" : "open",
                on_as[c->options.on_as], graze_rounding_name(c->rounding));
    for (int k = 0; k < JUDGED_COUNT; k++)
        if (c->judged[k])
            text_format(out, " %s", judged_name(k));
    text_format(out, "%s\n\n",
                c->options.has == GRAZE_HAS_SDF ? " (from the sign of sdf, negative inside)" : "");
    text_format(out,
                "| rows | agree | wrong | missing | apart | extra |\n|--:|--:|--:|--:|--:|--:|\n");
    text_format(out, "| %lu | %lu | %lu | %lu | %lu | %lu |\n\n", c->rows, c->agree, c->wrong,
                c->missing, c->apart, c->extra);
    text_put(out, "wrong: ");
    put_share(out, c->wrong, c->rows);
    text_put(out, " of the rows");
    for (int k = 0; k < JUDGED_COUNT; k++)
        if (c->judged[k])
            text_format(out, "; %s %lu", judged_name(k), c->column_wrong[k]);
    text_put(out, "\n");
    if (c->options.question == GRAZE_QUESTION_CLOSED)
        text_format(out,
                    "apart: `on` rows that may be seams, where the closed sweep goes on around the "
                    "point; answered in %lu, on %lu, out %lu\n",
                    c->apart_answers[0], c->apart_answers[1], c->apart_answers[2]);
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
    text_format(out, "| %s | %lu | %lu | ", *name ? name : "-", g->rows, g->wrong);
    put_share(out, g->wrong, g->rows);
    text_format(out, " | %lu | %lu |\n", g->missing, g->apart);
}

static void put_tally(text *out, grouping by, const tally *t) {
    if (!t->count)
        return;
    text_format(out,
                "\n| %s | rows | wrong | share | missing | apart |\n|---|--:|--:|--:|--:|--:|\n",
                by == BY_DISTANCE ? "k (distance 2^-k)" : grouping_name(by));
    for (size_t k = 0; k < t->count; k++)
        put_group(out, t->groups[k].name, &t->groups[k]);
    put_group(out, "(others)", &t->others);
}

static void put_disagreements(text *out, const graze_comparison *c) {
    if (c->shown)
        text_format(out, "\nThe first %zu of %lu disagreements:\n", c->shown,
                    c->wrong + c->missing + c->extra);
    for (size_t k = 0; k < c->shown; k++) {
        const disagreement *d = &c->disagreements[k];
        text_format(out, "\n%zu. ", k + 1);
        if (d->golden)
            text_format(out, "line %lu of the golden table, %s\n", d->golden_line, d->golden);
        else
            text_put(out, "no row of the golden table\n");
        if (d->candidate)
            text_format(out, "   candidate, line %lu, %s\n", d->candidate_line, d->candidate);
        else
            text_put(out, "   candidate: no row\n");
        text_put(out, "   `");
        if (*d->point)
            text_owned(out, explain_command(c, d));
        else
            text_put(out, "(no point)");
        text_put(out, "`\n");
    }
}

graze_status comparison_text(char **out, graze_context *context, const graze_comparison *c) {
    text bytes;
    text_init(&bytes);
    put_summary(&bytes, c);
    if (c->judged[JUDGED_PMC])
        put_matrix(&bytes, "pmc", pmc_words, 3, &c->confusion.pmc[0][0]);
    if (c->judged[JUDGED_CLASS])
        put_matrix(&bytes, "class", class_words, 5, &c->confusion.class_[0][0]);
    for (int g = 0; g < GROUPING_COUNT; g++)
        put_tally(&bytes, (grouping)g, &c->tallies[g]);
    put_disagreements(&bytes, c);
    return text_finish(out, context, &bytes);
}
