/* Reports errors of values, as Markdown and as JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/compare/compare.h"

#include "output/compare/counts.h"
#include "output/compare/judgement.h"

/* Groupings whose groups have errors of values in the report. */
static const grouping shown_by[] = {BY_STRATUM, BY_DISTANCE, BY_SDF};

enum { SHOWN_BY = sizeof shown_by / sizeof *shown_by };

static const char *truth_name(const graze_comparison *c) {
    return c->options.truth == GRAZE_TRUTH_OUTSIDE ? "outside" : "pseudo";
}

static unsigned long values_within(const errors *e) {
    return e->rows - e->over - e->under;
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

void put_values(text *out, const graze_comparison *c) {
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

void put_values_by(text *out, const graze_comparison *c) {
    for (int b = 0; b < SHOWN_BY && c->valued; b++) {
        const tally *t = &c->tallies[shown_by[b]];
        if (!t->count)
            continue;
        text_format(out, "\nErrors of sdf by %s:\n", grouping_title(shown_by[b]));
        put_errors_head(out, grouping_name(shown_by[b]));
        for (size_t k = 0; k < t->count; k++)
            if (t->groups[k].values)
                put_errors_line(out, c, t->groups[k].name, t->groups[k].values);
        if (t->others.values)
            put_errors_line(out, c, "(others)", t->others.values);
    }
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

static void put_json_group_errors(json_writer *w, const graze_comparison *c, const char *name,
                                  const group *one) {
    if (!one->values)
        return;
    json_open(w, NULL, '{');
    json_text(w, "value", name);
    put_json_errors(w, c, one->values);
    json_close(w, '}');
}

static void put_json_errors_by(json_writer *w, const graze_comparison *c) {
    json_open(w, "by", '{');
    for (int b = 0; b < SHOWN_BY; b++) {
        const tally *t = &c->tallies[shown_by[b]];
        if (!c->grouped[shown_by[b]])
            continue;
        json_open(w, grouping_name(shown_by[b]), '[');
        for (size_t k = 0; k < t->count; k++)
            put_json_group_errors(w, c, t->groups[k].name, &t->groups[k]);
        put_json_group_errors(w, c, "(others)", &t->others);
        json_close(w, ']');
    }
    json_close(w, '}');
}

void put_json_values(json_writer *w, const graze_comparison *c) {
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
    put_json_errors_by(w, c);
    json_close(w, '}');
}
