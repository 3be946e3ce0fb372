/* Targets for the command line: points, grids and the options themselves.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdlib.h>
#include <string.h>
#include "program/cli/cli.h"
#include "program/cli/values.h"
#include "program/io/io.h"
#include "program/points/points.h"
#include "program/run/run.h"
#include "fuzz.h"

/* The limits as the options hold them. */
static void low_limits(context_options *o) {
    graze_context *context = fuzz_context();
    memset(o, 0, sizeof *o);
    for (int k = 0; k < GRAZE_LIMIT_COUNT; k++)
        o->limits[k] = graze_context_limit(context, (graze_limit)k);
    graze_context_destroy(context);
}

/* Answer all rows of a block; the number of those before a fault. */
static size_t answer_block(answerer *a, block *b) {
    size_t rows = 0;
    for (size_t first = 0; first < b->count; first += RUN_ROWS) {
        row_run *r = &b->runs[first];
        size_t left = b->count - first;
        r->taken = left < RUN_ROWS ? left : RUN_ROWS;
        answer(a, r, b, first);
        EXPECT(r->done <= r->taken);
        EXPECT((r->done < r->taken) == (r->fault.status != 0));
        EXPECT(r->fault.status == 0 || r->fault.status == EXIT_INPUT ||
               r->fault.status == EXIT_LIMIT);
        size_t lines = 0;
        const struct row_text *table = &r->out[RESULT_TABLE];
        for (size_t k = 0; k < table->length; k++)
            lines += table->text[k] == '\n';
        EXPECT(lines == r->done);
        rows += r->done;
        if (r->fault.status)
            break;
    }
    return rows;
}

/* Points of a file, or contact points (1) that are moved (2), in both dimensions, whole and as a
 * shard, answered in both formats. */
static int read_points(const char *path, int dimension, shard part, graze_format format,
                       coordinate_options written, int sites) {
    static block *b;
    context_options o;
    csv *points;
    answerer a;
    size_t rows = 0;
    low_limits(&o);
    graze_context *context = fuzz_context();
    const graze_scene *scene = fuzz_still_scene(dimension);
    if (!b)
        b = block_create();
    EXPECT(b != NULL);
    EXPECT(csv_open(&points, path, NULL, dimension, part, context) == EXIT_DONE);
    if (sites)
        csv_expect_sites(points, sites > 1);
    const graze_row_options rows_of = {.size = sizeof rows_of, .format = format};
    answer_task task = {.context = &o,
                        .scene = scene,
                        .rows = &rows_of,
                        .source = {&points->columns, NULL, part, written}};
    EXPECT(answerer_init(&a, &task) == EXIT_DONE);
    block_reset(b, 0);
    int status = csv_fill(points, b, BLOCK_ROWS);
    EXPECT(status == EXIT_DONE || status == EXIT_INPUT || status == EXIT_LIMIT);
    EXPECT((status == EXIT_DONE) == (points->fault.status == 0));
    rows = answer_block(&a, b);
    answerer_clear(&a);
    csv_close(points);
    block_reset(b, 0);
    graze_context_destroy(context);
    return rows > 0;
}

int fuzz_points(const uint8_t *data, size_t size) {
    const char *path = fuzz_file("points.csv", data, size);
    const coordinate_options exact = {COORDINATES_EXACT, 0};
    const coordinate_options given = {COORDINATES_AS_GIVEN, 0}, decimal = {COORDINATES_DECIMAL, 0};
    const coordinate_options rounded = {COORDINATES_DECIMAL, 1 + (int)(size % 40)};
    const shard all = {0, 1};
    int solid = read_points(path, 3, all, GRAZE_FORMAT_CSV, given, 0);
    int plane = read_points(path, 2, all, GRAZE_FORMAT_JSONL, exact, 0);
    read_points(path, 2, (shard){1, 3}, GRAZE_FORMAT_CSV, decimal, 0);
    read_points(path, 2, all, GRAZE_FORMAT_CSV, exact, 1);
    read_points(path, 3, all, GRAZE_FORMAT_JSONL, exact, 2);
    read_points(fuzz_file("points.npy", data, size), 2, all, GRAZE_FORMAT_CSV, rounded, 0);
    return solid || plane;
}

/* --grid and --box: every point is in the box, the first and the last are its corners. */
static void check_grid(const grid *g, int d, graze_rationals low, graze_rationals high) {
    mpq_t *points = malloc(3 * RUN_ROWS * sizeof *points);
    EXPECT(points != NULL);
    for (size_t k = 0; k < 3 * RUN_ROWS; k++)
        mpq_init(points[k]);
    unsigned long count = g->count;
    size_t n = count < RUN_ROWS ? count : RUN_ROWS;
    graze_grid_points(points, g->points, 0, 1, n);
    for (size_t k = 0; k < n * (size_t)d; k++)
        EXPECT(mpq_cmp(low[k % (size_t)d], points[k]) <= 0 &&
               mpq_cmp(points[k], high[k % (size_t)d]) <= 0);
    for (int k = 0; k < d; k++)
        EXPECT(mpq_equal(points[k], low[k]));
    graze_grid_points(points, g->points, count - 1, 1, 1);
    for (int k = 0; k < d; k++)
        EXPECT(mpq_equal(points[k], high[k]));
    for (size_t k = 0; k < 3 * RUN_ROWS; k++)
        mpq_clear(points[k]);
    free(points);
}

int fuzz_grid(const uint8_t *data, size_t size) {
    section s[3];
    grid_options o;
    grid *g = NULL;
    fuzz_sections(s, 3, data, size);
    int d = s[2].size > 0 && s[2].data[0] == '3' ? 3 : 2, taken;
    char *sizes = fuzz_text(s[0]), *box = fuzz_text(s[1]);
    graze_context *context = fuzz_context();
    mpq_t low[3], high[3];
    mpq_inits(low[0], low[1], low[2], high[0], high[1], high[2], NULL);
    sizes[strcspn(sizes, "\n")] = '\0';
    box[strcspn(box, "\n")] = '\0';
    o.sizes = sizes;
    o.box = s[1].size ? box : NULL;
    int status = grid_open(&g, &o, context, fuzz_still_scene(d));
    EXPECT(status == EXIT_DONE || status == EXIT_USAGE || status == EXIT_LIMIT);
    taken = status == EXIT_DONE;
    if (taken && o.box) {
        EXPECT(box_read(low, high, box, d, context) == EXIT_DONE);
    } else if (taken) {
        EXPECT(graze_scene_box(low, high, context, fuzz_still_scene(d)) == GRAZE_OK);
    }
    if (taken) {
        check_grid(g, d, low, high);
        text notes;
        text_init(&notes);
        grid_notes(&notes, g);
        EXPECT(!notes.failed);
        text_clear(&notes);
    }
    grid_close(g);
    mpq_clears(low[0], low[1], low[2], high[0], high[1], high[2], NULL);
    graze_context_destroy(context);
    free(sizes);
    free(box);
    return taken;
}

/* A command's name on the first line, its words on the others; they are read, not obeyed. */
int fuzz_options(const uint8_t *data, size_t size) {
    static const command *const commands[] = {
        &command_check,  &command_classify, &command_explain,  &command_generate,
        &command_cases,  &command_compare,  &command_validate, &command_merge,
        &command_motion, &command_boundary, &command_draw,     &command_certify};
    words w;
    operands given;
    int help, taken = 0;
    fuzz_words(&w, "graze", (section){data, size});
    for (size_t k = 0; k < sizeof commands / sizeof *commands && w.count > 1; k++) {
        if (strcmp(w.word[1], commands[k]->name) != 0)
            continue;
        void *options = malloc(commands[k]->size);
        EXPECT(options != NULL);
        int status = command_read(&given, options, &help, commands[k], w.count - 1, w.word + 1);
        EXPECT(status == EXIT_DONE || status == EXIT_USAGE);
        EXPECT(given.count < w.count);
        operands_clear(&given);
        free(options);
        taken = status == EXIT_DONE;
    }
    free(w.text);
    return taken;
}
