/* Reports of graze validate: figures of the comparison under a verdict.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdio.h>
#include "base/context/scope.h"
#include "base/number/json.h"
#include "program/cli/values.h"

char *joined_texts(const char *a, const char *b) {
    char *text = malloc(strlen(a) + strlen(b) + 1);
    return text ? strcat(strcpy(text, a), b) : NULL;
}

/* Write the verdict on the candidate; none if rows are missing in its table. */
static void put_validation_verdict(char *out, size_t size, const graze_comparison_counts *n,
                                   graze_on_as on_as) {
    char other[96] = "";
    int any = on_as == GRAZE_ON_AS_ANY;
    if (n->has_no_on)
        snprintf(other, sizeof other, "; %lu wrong with `on` as %s",
                 n->wrong_as[any ? GRAZE_ON_AS_ON : GRAZE_ON_AS_ANY],
                 any ? "an answer of its own" : "any answer");
    if (n->missing)
        snprintf(out, size, "none: %lu of %lu rows are missing", n->missing, n->rows);
    else if (n->wrong + n->extra == 0)
        snprintf(out, size, "no difference in %lu rows%s%s", n->rows,
                 n->undecided ? ", the undecided ones not judged" : "", other);
    else
        snprintf(out, size, "differs from the exact answer: %lu of %lu rows wrong, %lu extra%s",
                 n->wrong, n->rows, n->extra, other);
}

/* Put a member on a line of its own. Bytes that are not printable ASCII become question marks. */
static void put_json_text(json_writer *w, const char *name, const char *value) {
    HELD(text, plain);
    for (; *value; value++)
        text_bytes(&plain, *value < 0x20 || *value > 126 ? "?" : value, 1);
    json_line(w, 0);
    json_text(w, name, plain.length ? plain.data : "");
    w->out->failed |= plain.failed;
}

static void put_json_count(json_writer *w, const char *name, unsigned long value) {
    json_line(w, 0);
    json_count(w, name, value);
}

/* The options that would make the same points again, malloc'ed. */
static char *made_with(const validate_options *o) {
    text t;
    text_init(&t);
    text_format(&t, "-n %lu --seed %llu", o->generate.count, o->generate.seed.seed);
    if (o->generate.strata)
        text_format(&t, " --strata %s", o->generate.strata);
    text_put(&t, o->generate.representable ? " --representable binary64" : "");
    return text_take(&t);
}

/* The figures of a report. They are whole numbers, whose text does not depend on the locale. */
typedef struct validation_figures {
    char verdict[256];
    char *made,
        *lost; /* how the points were made, NULL if they were given; strata without points */
    unsigned long milliseconds, rate;
} validation_figures;

static void put_json_report(text *out, const validation_figures *f, const validate_options *o,
                            const char *body) {
    json_writer writer = {.out = out, .spaced = 1}, *w = &writer;
    json_open(w, NULL, '{');
    put_json_text(w, "command", o->candidate);
    put_json_text(w, "solid", o->classify.scene.solid);
    put_json_text(w, "motion", o->classify.scene.motion);
    put_json_text(w, "verdict", f->verdict);
    if (f->made)
        put_json_text(w, "made-with", f->made);
    if (*f->lost)
        put_json_text(w, "points", f->lost);
    put_json_count(w, "milliseconds", f->milliseconds);
    put_json_count(w, "rows-per-second", f->rate);
    json_line(w, 0);
    json_number(w, "comparison", body);
    json_close(w, '}');
    text_put(out, "\n");
}

static void put_text_report(text *out, const validation_figures *f, const validate_options *o,
                            const char *body) {
    text_put(out, "# Validation\n\ncommand: ");
    text_code(out, o->candidate);
    text_put(out, "\nsolid: ");
    text_markdown(out, o->classify.scene.solid);
    text_put(out, "\nmotion: ");
    text_markdown(out, o->classify.scene.motion);
    text_format(out, "\nverdict: %s\n", f->verdict);
    if (f->made)
        text_format(out, "made with: %s\n%s", f->made,
                    o->generate.representable || o->generate.coordinates.form == COORDINATES_DECIMAL
                        ? ""
                        : "points: with ratios such as 1/3, which readers of floats misread; "
                          "--representable binary64 has decimals\n");
    if (*f->lost)
        text_format(out, "points: %s\n", f->lost);
    text_format(out, "time: %lu.%03lu s, %lu rows a second\n\n", f->milliseconds / 1000,
                f->milliseconds % 1000, f->rate);
    text_put(out, body);
}

static void put_validation(text *out, const validation *v, const validate_options *o,
                           const char *body, int json) {
    graze_comparison_counts n = graze_comparison_count(v->comparison);
    validation_figures f = {.milliseconds = (unsigned long)(1000 * v->seconds + 0.5)};
    f.rate = f.milliseconds ? (unsigned long)((double)n.rows / v->seconds + 0.5) : 0;
    put_validation_verdict(f.verdict, sizeof f.verdict, &n, o->compare.on_as);
    f.made = o->points ? NULL : made_with(o);
    f.lost = lost_strata_text(&v->made.lost, json ? "; " : "\npoints: ");
    out->failed |= !f.lost || (!o->points && !f.made);
    if (!out->failed)
        (json ? put_json_report : put_text_report)(out, &f, o, body);
    free(f.made);
    free(f.lost);
}

/* Write one report to the file OUTPUT + suffix, or to standard output. The report is complete
 * before the file is opened. */
static int write_validation(const validation *v, const validate_options *o, const char *suffix,
                            graze_comparison_format format) {
    FREED(char, body, NULL);
    FREED(char, path, o->output ? joined_texts(o->output, suffix) : NULL);
    HELD(text, report);
    TRY(complain_of(graze_comparison_report(&body, v->context, v->comparison, format), v->context));
    put_validation(&report, v, o, body, format == GRAZE_COMPARISON_JSON);
    if (o->output && !path)
        return complain(EXIT_IO, "out of memory");
    return output_made(path, &report);
}

int validation_report(const validation *v, const validate_options *o) {
    graze_comparison_counts n = graze_comparison_count(v->comparison);
    if (o->output) {
        TRY(write_validation(v, o, ".md", GRAZE_COMPARISON_TEXT));
        TRY(write_validation(v, o, ".json", GRAZE_COMPARISON_JSON));
    } else {
        TRY(write_validation(v, o, "", o->format));
    }
    return n.wrong + n.missing + n.extra ? EXIT_NO : EXIT_DONE;
}
