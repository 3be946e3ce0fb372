/* Reports of comparisons as JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Counts are JSON numbers, everything else text. Bytes above 127 that come from the files become
 * `?`, so that the object is UTF-8.
 */
#include "output/compare/judgement.h"

static void put_json_summary(json_writer *w, const graze_comparison *c) {
    static const char *const on_as[] = {"on", "any", "in", "out"};
    json_text(w, "golden", c->options.transient ? NULL : c->golden);
    json_text(w, "candidate", c->options.transient ? NULL : c->candidate);
    if (c->options.transient) {
        json_text(w, "golden-columns", c->golden_columns);
        json_text(w, "candidate-columns", c->candidate_columns);
    }
    json_text(w, "hint", comparison_hint(c));
    put_json_sites(w, c);
    json_text(w, "question", c->options.question == GRAZE_QUESTION_CLOSED ? "closed" : "open");
    json_text(w, "on-as", on_as[c->options.on_as]);
    json_text(w, "candidate-has", c->options.has == GRAZE_HAS_SDF ? "sdf" : "columns");
    json_text(w, "round", graze_rounding_name(c->rounding));
    put_json_rows(w, c);
    json_count(w, "rows", c->rows);
    json_count(w, "agree", c->agree);
    json_count(w, "wrong", c->wrong);
    json_count(w, "missing", c->missing);
    json_count(w, "undecided", c->undecided);
    json_count(w, "undecided-golden-rows", c->open);
    json_count(w, "golden-rows-of-pmc-alone", c->of_pmc);
    json_count(w, "extra", c->extra);
    json_open(w, "wrong-by-column", '{');
    for (column j = COLUMN_X; j < COLUMN_OPTIONS; j++)
        if (c->judged[j])
            json_count(w, column_name(j), c->column_wrong[j]);
    json_close(w, '}');
    json_open(w, "undecided-answers", '{');
    for (int k = 0; k < 3; k++)
        json_count(w, pmc_words[k], c->undecided_answers[k]);
    json_close(w, '}');
}

static void put_json_matrix(json_writer *w, const char *name, const char *const *words, int count,
                            const unsigned long *cells) {
    json_open(w, name, '{');
    for (int r = 0; r < count; r++) {
        json_open(w, words[r], '{');
        for (int k = 0; k <= count; k++)
            json_count(w, k < count ? words[k] : "missing", cells[r * (count + 1) + k]);
        json_close(w, '}');
    }
    json_close(w, '}');
}

/* Write errors as members of the JSON object that is open. */
static void put_json_errors(json_writer *w, const graze_comparison *c, const errors *e) {
    json_count(w, "values", e->rows);
    json_count(w, "within", values_within(e));
    json_count(w, "over", e->over);
    json_count(w, "under", e->under);
    if (c->options.sdf_tolerance)
        json_count(w, "beyond", e->beyond);
    put_json_quantiles(w, e, QUANTILES);
    put_ceiling(w, "largest-over", e->largest_over);
}

/* Write the counts of a group or, if `values`, the errors of its values; nothing without any. */
static void put_json_group(json_writer *w, const graze_comparison *c, const char *name,
                           const group *one, int values) {
    if (values ? !one->values : !one->rows)
        return;
    json_open(w, NULL, '{');
    json_text(w, "value", name);
    if (values) {
        put_json_errors(w, c, one->values);
    } else {
        json_count(w, "rows", one->rows);
        json_count(w, "wrong", one->wrong);
        json_count(w, "missing", one->missing);
        json_count(w, "undecided", one->undecided);
    }
    json_close(w, '}');
}

static void put_json_groups(json_writer *w, const graze_comparison *c, int values) {
    json_open(w, "by", '{');
    for (int by = 0; by < (values ? (int)SHOWN_BY : (int)GROUPING_COUNT); by++) {
        const tally *t = &c->tallies[by];
        if (!c->grouped[by])
            continue;
        json_open(w, column_name(groupings[by].of), '[');
        for (size_t k = 0; k < t->count; k++)
            put_json_group(w, c, t->groups[k].name, &t->groups[k], values);
        put_json_group(w, c, "(others)", &t->others, values);
        json_close(w, ']');
    }
    json_close(w, '}');
}

static void put_json_values(json_writer *w, const graze_comparison *c) {
    if (c->options.motion_error) {
        json_text(w, "motion-error", c->options.motion_error);
        json_count(w, "undecided-by-motion-error", c->undecided_by_motion);
    }
    if (!c->valued)
        return;
    json_open(w, "errors-of-sdf", '{');
    json_text(w, "truth", truth_name(c));
    json_text(w, "tolerance", c->options.sdf_tolerance);
    put_json_errors(w, c, &c->values);
    put_json_groups(w, c, 1);
    json_close(w, '}');
}

static void put_json_disagreements(json_writer *w, const graze_comparison *c) {
    json_open(w, "disagreements", '[');
    for (size_t k = 0; k < c->shown; k++) {
        const disagreement *d = &c->disagreements[k];
        json_open(w, NULL, '{');
        if (c->options.transient) {
            json_text(w, "golden-row", d->golden_row);
            json_text(w, "candidate-row", d->candidate_row);
        } else {
            json_count(w, "golden-line", d->golden_line);
            json_count(w, "candidate-line", d->candidate_line);
        }
        json_text(w, "point", d->point);
        json_text(w, "golden", d->golden);
        json_text(w, "candidate", d->candidate);
        if (*d->point)
            json_owned(w, "explain", explain_command(c, d));
        else
            json_text(w, "explain", NULL);
        json_close(w, '}');
    }
    json_close(w, ']');
}

graze_status comparison_json(char **out, graze_context *context, const graze_comparison *c) {
    text bytes;
    text_init(&bytes);
    json_writer writer = {.out = &bytes, .pretty = 1}, *w = &writer;
    json_open(w, NULL, '{');
    put_json_summary(w, c);
    if (c->judged[COLUMN_PMC])
        put_json_matrix(w, "pmc", pmc_words, 3, &c->confusion.pmc[0][0]);
    if (c->judged[COLUMN_CLASS])
        put_json_matrix(w, "class", class_words, 5, &c->confusion.class_[0][0]);
    put_json_groups(w, c, 0);
    put_json_values(w, c);
    put_json_disagreements(w, c);
    json_close(w, '}');
    for (size_t k = 0; k < bytes.length; k++)
        bytes.data[k] = (unsigned char)bytes.data[k] > 127 ? '?' : bytes.data[k];
    return text_finish(out, context, &bytes);
}
