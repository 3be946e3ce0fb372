/* The comparison for a person: Markdown that also reads well as it is.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "compare/compare.h"

const char *grouping_name(grouping g) {
    static const char *const names[GROUPING_COUNT] = {"stratum", "k", "class", "definition",
                                                      "case"};
    return names[g];
}

/* A word for the shell; quoted where it holds more than plain characters. */
static void put_word(FILE *file, const char *word) {
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                "_./-+:@%,=";
    if (*word && strspn(word, plain) == strlen(word)) {
        fputs(word, file);
        return;
    }
    fputc('\'', file);
    for (; *word; word++)
        fputs(*word == '\'' ? "'\\''" : (char[]){*word, '\0'}, file);
    fputc('\'', file);
}

char *explain_command(const graze_comparison *c, const disagreement *d) {
    char *text = NULL;
    size_t length;
    FILE *file = open_memstream(&text, &length);
    if (!file)
        return NULL;
    fputs("graze explain ", file);
    put_word(file, c->solid);
    fputc(' ', file);
    put_word(file, c->motion);
    fprintf(file, " %s%s", d->point, c->explain_options);
    if (fclose(file) == 0)
        return text;
    free(text);
    return NULL;
}

/* A share with two digits, rounded to nearest, by whole numbers: the locale has no say in it. */
static void put_share(FILE *file, unsigned long part, unsigned long whole) {
    unsigned long long hundredths = whole ? (20000ull * part + whole) / (2ull * whole) : 0;
    fprintf(file, "%llu.%02llu %%", hundredths / 100, hundredths % 100);
}

static void put_summary(FILE *file, const graze_comparison *c) {
    static const char *const on_as[] = {"an answer of its own", "right whatever is answered", "in",
                                        "out"};
    static const char *const rounding[] = {"none", "binary64", "binary32"};
    fprintf(file, "golden: %s\ncandidate: %s\n", c->golden, c->candidate);
    fprintf(file, "question: %s sweep; `on` counts as %s; rounding: %s\njudged:",
            c->options.question == GRAZE_QUESTION_CLOSED ? "closed" : "open",
            on_as[c->options.on_as], rounding[c->rounding]);
    for (int k = 0; k < JUDGED_COUNT; k++)
        if (c->judged[k])
            fprintf(file, " %s", judged_name(k));
    fprintf(file, "%s\n\n",
            c->options.has == GRAZE_HAS_SDF ? " (from the sign of sdf, negative inside)" : "");
    fprintf(file,
            "| rows | agree | wrong | missing | apart | extra |\n|--:|--:|--:|--:|--:|--:|\n");
    fprintf(file, "| %lu | %lu | %lu | %lu | %lu | %lu |\n\n", c->rows, c->agree, c->wrong,
            c->missing, c->apart, c->extra);
    fputs("wrong: ", file);
    put_share(file, c->wrong, c->rows);
    fputs(" of the rows", file);
    for (int k = 0; k < JUDGED_COUNT; k++)
        if (c->judged[k])
            fprintf(file, "; %s %lu", judged_name(k), c->column_wrong[k]);
    fputs("\n", file);
    if (c->options.question == GRAZE_QUESTION_CLOSED)
        fprintf(file,
                "apart: `on` rows that may be seams, where the closed sweep goes on around the "
                "point; answered in %lu, on %lu, out %lu\n",
                c->apart_answers[0], c->apart_answers[1], c->apart_answers[2]);
}

static void put_matrix(FILE *file, const char *name, const char *const *words, int count,
                       const unsigned long *cells) {
    fprintf(file, "\n| golden %s \\ candidate |", name);
    for (int k = 0; k < count; k++)
        fprintf(file, " %s |", words[k]);
    fputs(" missing |\n|---|", file);
    for (int k = 0; k <= count; k++)
        fputs("--:|", file);
    fputs("\n", file);
    for (int r = 0; r < count; r++) {
        fprintf(file, "| %s |", words[r]);
        for (int k = 0; k <= count; k++)
            fprintf(file, " %lu |", cells[r * (count + 1) + k]);
        fputs("\n", file);
    }
}

static void put_group(FILE *file, const char *name, const group *g) {
    if (!g->rows)
        return;
    fprintf(file, "| %s | %lu | %lu | ", *name ? name : "-", g->rows, g->wrong);
    put_share(file, g->wrong, g->rows);
    fprintf(file, " | %lu | %lu |\n", g->missing, g->apart);
}

static void put_tally(FILE *file, grouping by, const tally *t) {
    if (!t->count)
        return;
    fprintf(file, "\n| %s | rows | wrong | share | missing | apart |\n|---|--:|--:|--:|--:|--:|\n",
            by == BY_DISTANCE ? "k (distance 2^-k)" : grouping_name(by));
    for (size_t k = 0; k < t->count; k++)
        put_group(file, t->groups[k].name, &t->groups[k]);
    put_group(file, "(others)", &t->others);
}

static int put_disagreements(FILE *file, const graze_comparison *c) {
    if (c->shown)
        fprintf(file, "\nThe first %zu of %lu disagreements:\n", c->shown,
                c->wrong + c->missing + c->extra);
    for (size_t k = 0; k < c->shown; k++) {
        const disagreement *d = &c->disagreements[k];
        fprintf(file, "\n%zu. ", k + 1);
        if (d->golden)
            fprintf(file, "line %lu of the golden table, %s\n", d->golden_line, d->golden);
        else
            fputs("no row of the golden table\n", file);
        if (d->candidate)
            fprintf(file, "   candidate, line %lu, %s\n", d->candidate_line, d->candidate);
        else
            fputs("   candidate: no row\n", file);
        char *command = *d->point ? explain_command(c, d) : strdup("(no point)");
        if (!command)
            return 0;
        fprintf(file, "   `%s`\n", command);
        free(command);
    }
    return 1;
}

graze_status comparison_text(char **out, graze_context *context, const graze_comparison *c) {
    size_t length;
    *out = NULL;
    FILE *file = open_memstream(out, &length);
    if (!file)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory");
    put_summary(file, c);
    if (c->judged[JUDGED_PMC])
        put_matrix(file, "pmc", pmc_words, 3, &c->confusion.pmc[0][0]);
    if (c->judged[JUDGED_CLASS])
        put_matrix(file, "class", class_words, 5, &c->confusion.class_[0][0]);
    for (int g = 0; g < GROUPING_COUNT; g++)
        put_tally(file, (grouping)g, &c->tallies[g]);
    int done = put_disagreements(file, c);
    if (fclose(file) == 0 && done)
        return GRAZE_OK;
    free(*out);
    *out = NULL;
    return context_fail(context, GRAZE_ESYSTEM, "out of memory");
}
