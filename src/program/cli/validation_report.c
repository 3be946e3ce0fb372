/* Reports of graze validate: figures of the comparison under a verdict.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/scope.h"
#include "base/number/text.h"
#include "program/cli/values.h"
#include "program/io/io.h"
#include "program/points/points.h"

char *joined_texts(const char *a, const char *b) {
    char *text = malloc(strlen(a) + strlen(b) + 1);
    return text ? strcat(strcpy(text, a), b) : NULL;
}

/* Rows without an answer are no evidence for or against a candidate: no verdict then. */
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

/* Add the text between the quotes of a JSON string; `?` stands for bytes that are not printable
 * ASCII. */
static void put_json_quoted(text *out, const char *string) {
    for (; *string; string++) {
        unsigned char c = (unsigned char)*string;
        char plain[] = {c < 0x20 || c > 126 ? '?' : *string, '\0'};
        text_put(out, c == '"' ? "\\\"" : c == '\\' ? "\\\\" : plain);
    }
}

static void put_json_text(text *out, const char *name, const char *value) {
    text_format(out, "\"%s\": \"", name);
    put_json_quoted(out, value);
    text_put(out, "\",\n");
}

/* Name the strata without points, if there are any. */
static void put_lost(text *out, const lost_strata *lost, graze_comparison_format format) {
    FREED(char, said,
          lost_strata_text(lost, format == GRAZE_COMPARISON_JSON ? "; " : "\npoints: "));
    out->failed |= !said;
    if (!said || !*said)
        return;
    if (format == GRAZE_COMPARISON_JSON)
        put_json_text(out, "points", said);
    else
        text_format(out, "points: %s\n", said);
}

/* Add the options that make the same points again, and a warning of ratios in them. */
static void put_made_with(text *out, const validate_options *o, graze_comparison_format format) {
    HELD(text, made);
    if (o->points)
        return;
    text_format(&made, "-n %lu --seed %llu", o->generate.count, o->generate.seed.seed);
    if (o->generate.strata)
        text_format(&made, " --strata %s", o->generate.strata);
    text_put(&made, o->generate.representable ? " --representable binary64" : "");
    out->failed |= made.failed;
    if (made.failed)
        return;
    if (format == GRAZE_COMPARISON_JSON)
        put_json_text(out, "made-with", made.data);
    else
        text_format(out, "made with: %s\n%s", made.data,
                    o->generate.representable || o->generate.coordinates.form == COORDINATES_DECIMAL
                        ? ""
                        : "points: with ratios such as 1/3, which readers of floats misread; "
                          "--representable binary64 has decimals\n");
}

static void put_validated(text *out, const validate_options *o, const char *verdict) {
    text_put(out, "# Validation\n\ncommand: ");
    text_code(out, o->candidate);
    text_put(out, "\nsolid: ");
    text_markdown(out, o->classify.scene.solid);
    text_put(out, "\nmotion: ");
    text_markdown(out, o->classify.scene.motion);
    text_format(out, "\nverdict: %s\n", verdict);
}

/* Whole numbers keep the locale's decimal comma out. */
static void put_validation(text *out, const validation *v, const validate_options *o,
                           const char *body, graze_comparison_format format) {
    graze_comparison_counts n = graze_comparison_count(v->comparison);
    unsigned long milliseconds = (unsigned long)(1000 * v->seconds + 0.5);
    unsigned long rate = milliseconds ? (unsigned long)((double)n.rows / v->seconds + 0.5) : 0;
    char verdict[256];
    put_validation_verdict(verdict, sizeof verdict, &n, o->compare.on_as);
    if (format == GRAZE_COMPARISON_JSON) {
        text_put(out, "{\n");
        put_json_text(out, "command", o->candidate);
        put_json_text(out, "solid", o->classify.scene.solid);
        put_json_text(out, "motion", o->classify.scene.motion);
        put_json_text(out, "verdict", verdict);
        put_made_with(out, o, format);
        put_lost(out, &v->made.lost, format);
        text_format(out, "\"milliseconds\": %lu,\n\"rows-per-second\": %lu,\n", milliseconds, rate);
        text_put(out, "\"comparison\": ");
        text_put(out, body);
        text_put(out, "}\n");
        return;
    }
    put_validated(out, o, verdict);
    put_made_with(out, o, format);
    put_lost(out, &v->made.lost, format);
    text_format(out, "time: %lu.%03lu s, %lu rows a second\n\n", milliseconds / 1000,
                milliseconds % 1000, rate);
    text_put(out, body);
}

/* One report to a file NAME + suffix, or to standard output; it is made whole before the file is
 * opened. */
static int write_validation(const validation *v, const validate_options *o, const char *suffix,
                            graze_comparison_format format) {
    FREED(char, body, NULL);
    FREED(char, path, o->output ? joined_texts(o->output, suffix) : NULL);
    HELD(text, report);
    TRY(complain_of(graze_comparison_report(&body, v->context, v->comparison, format), v->context));
    put_validation(&report, v, o, body, format);
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
