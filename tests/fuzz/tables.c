/* Targets for tables: compared, exported, merged.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _GNU_SOURCE /* memmem */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "program/cli/cli.h"
#include "program/cli/values.h"
#include "program/io/io.h"
#include "program/points/points.h"
#include "fuzz.h"

/* The counts of a comparison agree with one another, and both forms of its report are whole. */
static void look_at(graze_context *context, const graze_comparison *c) {
    char *text = NULL, *json = NULL;
    graze_comparison_counts n = graze_comparison_count(c);
    EXPECT(n.rows == n.agree + n.wrong + n.undecided + n.missing);
    EXPECT(graze_comparison_report(&text, context, c, GRAZE_COMPARISON_TEXT) == GRAZE_OK);
    EXPECT(graze_comparison_report(&json, context, c, GRAZE_COMPARISON_JSON) == GRAZE_OK);
    EXPECT(*text && fuzz_is_json(json, strlen(json)));
    graze_free(text);
    graze_free(json);
}

/* A golden table, a candidate's, and a byte for each option. */
int fuzz_compare(const uint8_t *data, size_t size) {
    section s[3];
    fuzz_sections(s, 3, data, size);
    bytes b = {s[2].data, s[2].size};
    graze_compare_options o = {.size = sizeof o,
                               .question = (graze_question)take_from(&b, 0, 1),
                               .on_as = (graze_on_as)take_from(&b, 0, 3),
                               .has = (graze_candidate_has)take_from(&b, 0, 1),
                               .show = (size_t)take_from(&b, 0, 9)};
    graze_context *context = fuzz_context();
    graze_comparison *c = NULL;
    EXPECT(graze_context_set_rounding(context, (graze_rounding)take_from(&b, 0, 2)) == GRAZE_OK);
    const char *golden = fuzz_file("golden.csv", s[0].data, s[0].size);
    const char *candidate = fuzz_file("candidate.csv", s[1].data, s[1].size);
    graze_status status = graze_compare(&c, context, golden, candidate, &o);
    int taken = fuzz_taken(status, context, c);
    if (taken)
        look_at(context, c);
    graze_comparison_destroy(c);
    /* A table agrees with itself, if it is a golden one. */
    status = graze_compare(&c, context, golden, golden, NULL);
    if (fuzz_taken(status, context, c)) {
        graze_comparison_counts n = graze_comparison_count(c);
        EXPECT(n.wrong + n.missing + n.extra == 0);
    }
    graze_comparison_destroy(c);
    graze_context_destroy(context);
    return taken;
}

/* A byte of options, names of further columns, and rows. */
int fuzz_export(const uint8_t *data, size_t size) {
    section s[2];
    int how = size ? data[0] : 0, taken = 0;
    const graze_scene *scene = fuzz_still_scene(how & 1 ? 3 : 2);
    graze_context *context = fuzz_context();
    fuzz_sections(s, 2, data + (size > 0), size - (size > 0));
    char *names = fuzz_text(s[0]);
    names[strcspn(names, "\n")] = '\0';
    for (int form = GRAZE_FORMAT_VTK; form <= GRAZE_FORMAT_NPY; form++) {
        const graze_row_options o = {.size = sizeof o,
                                     .format = (graze_format)form,
                                     .columns = how & 2 ? GRAZE_COLUMNS_PMC : GRAZE_COLUMNS_ALL,
                                     .topo = (how & 6) == 4,
                                     .sdf = (how & 10) == 8};
        char *out = NULL;
        size_t length = 0;
        graze_status status =
            graze_report_export(&out, &length, context, scene, (const char *)s[1].data, s[1].size,
                                *names ? names : NULL, NULL, &o);
        if (fuzz_taken(status, context, out)) {
            EXPECT(length > 10);
            EXPECT(memcmp(out, form == GRAZE_FORMAT_NPY ? "\x93NUMPY" : "# vtk ", 6) == 0);
            taken = 1;
        }
        graze_free(out);
    }
    free(names);
    graze_context_destroy(context);
    return taken;
}

/* A command that writes a file. */
static int run(const command *c, char **argv, int argc) {
    int status = command_run(c, argc, argv);
    EXPECT(status == EXIT_DONE || status == EXIT_INPUT || status == EXIT_LIMIT);
    return status == EXIT_DONE;
}

static size_t rows_of(const char *text) {
    size_t rows = 0, head = 1;
    for (const char *at = text; *at; at = strchr(at, '\n') ? strchr(at, '\n') + 1 : "")
        if (*at != '#')
            rows += !head, head = 0;
    return rows;
}

/* Put the right checksum where a part has one, which no fuzzer finds. */
static void seal(char *part, size_t size) {
    static const char key[] = "bytes-checksum ";
    char digits[17];
    for (char *at = part; (at = memmem(at, size - (size_t)(at - part), key, strlen(key)));) {
        char *line = at, *value = at + strlen(key);
        checksum sum = {0, 0, 0};
        while (line > part && line[-1] != '\n')
            line--;
        checksum_add(&sum, part, (size_t)(line - part));
        snprintf(digits, sizeof digits, "%016llx", checksum_value(&sum));
        if (size - (size_t)(value - part) >= 16)
            memcpy(value, digits, 16);
        at = value;
    }
}

static const char *sealed_file(const char *name, const section *s) {
    char *copy = malloc(s->size + 1);
    if (!copy)
        abort();
    if (s->size)
        memcpy(copy, s->data, s->size);
    seal(copy, s->size);
    const char *path = fuzz_file(name, (const uint8_t *)copy, s->size);
    free(copy);
    return path;
}

/* Up to three parts. What is merged has the rows that its last line counts. */
int fuzz_merge(const uint8_t *data, size_t size) {
    section s[3];
    static const char *const names[] = {"part-1.csv", "part-2.csv", "part-3.csv"};
    char *argv[8] = {"merge", "--quiet", "--output"};
    int argc = 4;
    fuzz_sections(s, 3, data, size);
    argv[3] = (char *)fuzz_file("merged.csv", NULL, 0);
    for (int k = 0; k < 3; k++)
        if (s[k].size || k == 0)
            argv[argc++] = (char *)sealed_file(names[k], &s[k]);
    int taken = run(&command_merge, argv, argc);
    if (taken) {
        size_t length;
        char *text = fuzz_read(argv[3], &length);
        /* Parts with NUL bytes in their rows are copied as they are. */
        const char *last = strlen(text) == length ? strstr(text, "\n# complete ") : NULL;
        if (last)
            EXPECT(rows_of(text) == strtoul(last + 12, NULL, 10) ||
                   strstr(last + 1, "\n# complete "));
        free(text);
    }
    return taken;
}
