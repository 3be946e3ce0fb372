/* Reports of comparisons as JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Counts are JSON numbers, everything else text. Bytes above 127 that come from the files become
 * `?`, so that the object is UTF-8.
 */
#include "output/compare/report_json.h"

#include <stdlib.h>
#include <string.h>
#include <yajl/yajl_gen.h>
#include "base/context/json_memory.h"
#include "output/compare/json_put.h"
#include "output/compare/judgement.h"
#include "output/compare/report_sites.h"
#include "output/compare/report_text.h"
#include "output/compare/report_values.h"

static void put_json_summary(yajl_gen g, const graze_comparison *c) {
    static const char *const on_as[] = {"on", "any", "in", "out"};
    put_named(g, "golden", c->options.transient ? NULL : c->golden);
    put_named(g, "candidate", c->options.transient ? NULL : c->candidate);
    if (c->options.transient) {
        put_named(g, "golden-columns", c->golden_columns);
        put_named(g, "candidate-columns", c->candidate_columns);
    }
    put_named(g, "hint", comparison_hint(c));
    put_json_sites(g, c);
    put_named(g, "question", c->options.question == GRAZE_QUESTION_CLOSED ? "closed" : "open");
    put_named(g, "on-as", on_as[c->options.on_as]);
    put_named(g, "candidate-has", c->options.has == GRAZE_HAS_SDF ? "sdf" : "columns");
    put_named(g, "round", graze_rounding_name(c->rounding));
    put_json_count(g, "rows", c->rows);
    put_json_count(g, "agree", c->agree);
    put_json_count(g, "wrong", c->wrong);
    put_json_count(g, "missing", c->missing);
    put_json_count(g, "undecided", c->undecided);
    put_json_count(g, "extra", c->extra);
    put_key_text(g, "wrong-by-column");
    yajl_gen_map_open(g);
    for (int k = 0; k < JUDGED_COUNT; k++)
        if (c->judged[k])
            put_json_count(g, judged_name(k), c->column_wrong[k]);
    yajl_gen_map_close(g);
    put_key_text(g, "undecided-answers");
    yajl_gen_map_open(g);
    for (int k = 0; k < 3; k++)
        put_json_count(g, pmc_words[k], c->undecided_answers[k]);
    yajl_gen_map_close(g);
}

static void put_json_matrix(yajl_gen g, const char *name, const char *const *words, int count,
                            const unsigned long *cells) {
    put_key_text(g, name);
    yajl_gen_map_open(g);
    for (int r = 0; r < count; r++) {
        put_key_text(g, words[r]);
        yajl_gen_map_open(g);
        for (int k = 0; k <= count; k++)
            put_json_count(g, k < count ? words[k] : "missing", cells[r * (count + 1) + k]);
        yajl_gen_map_close(g);
    }
    yajl_gen_map_close(g);
}

static void put_json_group(yajl_gen g, const char *name, const group *one) {
    if (!one->rows)
        return;
    yajl_gen_map_open(g);
    put_named(g, "value", name);
    put_json_count(g, "rows", one->rows);
    put_json_count(g, "wrong", one->wrong);
    put_json_count(g, "missing", one->missing);
    put_json_count(g, "undecided", one->undecided);
    yajl_gen_map_close(g);
}

static void put_tallies(yajl_gen g, const graze_comparison *c) {
    put_key_text(g, "by");
    yajl_gen_map_open(g);
    for (int by = 0; by < GROUPING_COUNT; by++) {
        const tally *t = &c->tallies[by];
        if (!c->grouped[by])
            continue;
        put_key_text(g, grouping_name((grouping)by));
        yajl_gen_array_open(g);
        for (size_t k = 0; k < t->count; k++)
            put_json_group(g, t->groups[k].name, &t->groups[k]);
        put_json_group(g, "(others)", &t->others);
        yajl_gen_array_close(g);
    }
    yajl_gen_map_close(g);
}

static int put_json_disagreements(yajl_gen g, const graze_comparison *c) {
    int done = 1;
    put_key_text(g, "disagreements");
    yajl_gen_array_open(g);
    for (size_t k = 0; k < c->shown; k++) {
        const disagreement *d = &c->disagreements[k];
        char *command = explain_command(c, d);
        done &= command != NULL;
        yajl_gen_map_open(g);
        if (c->options.transient) {
            put_named(g, "golden-row", d->golden_row);
            put_named(g, "candidate-row", d->candidate_row);
        } else {
            put_json_count(g, "golden-line", d->golden_line);
            put_json_count(g, "candidate-line", d->candidate_line);
        }
        put_named(g, "point", d->point);
        put_named(g, "golden", d->golden);
        put_named(g, "candidate", d->candidate);
        put_named(g, "explain", *d->point ? command : NULL);
        yajl_gen_map_close(g);
        free(command);
    }
    yajl_gen_array_close(g);
    return done;
}

static void print_comparison(void *data, const char *bytes, size_t length) {
    text *out = data;
    size_t before = out->length;
    text_bytes(out, bytes, length);
    for (size_t k = before; k < out->length; k++)
        out->data[k] = (unsigned char)out->data[k] > 127 ? '?' : out->data[k];
}

/* 0 when memory runs out outside of `out`. */
static int generate(text *out, json_memory *memory, const graze_comparison *c) {
    json_memory_init(memory);
    if (setjmp(memory->short_of) != 0)
        return 0;
    yajl_gen g = yajl_gen_alloc(&memory->functions);
    yajl_gen_config(g, yajl_gen_print_callback, print_comparison, out);
    yajl_gen_config(g, yajl_gen_beautify, 1);
    yajl_gen_config(g, yajl_gen_indent_string, "  ");
    yajl_gen_map_open(g);
    put_json_summary(g, c);
    if (c->judged[JUDGED_PMC])
        put_json_matrix(g, "pmc", pmc_words, 3, &c->confusion.pmc[0][0]);
    if (c->judged[JUDGED_CLASS])
        put_json_matrix(g, "class", class_words, 5, &c->confusion.class_[0][0]);
    put_tallies(g, c);
    put_json_values(g, c);
    int done = put_json_disagreements(g, c);
    yajl_gen_map_close(g);
    return done;
}

graze_status comparison_json(char **out, graze_context *context, const graze_comparison *c) {
    text bytes;
    json_memory memory;
    text_init(&bytes);
    if (!generate(&bytes, &memory, c))
        bytes.failed = 1;
    json_memory_clear(&memory);
    return text_finish(out, context, &bytes);
}
