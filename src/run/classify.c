/* Classifies points and writes the table.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Points come in blocks, which threads answer while the next ones are read and the last ones
 * written, in order. A failure leaves the whole rows before it and no `# complete` line.
 */
#include "run/classify.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "run/csv.h"
#include "run/interrupt.h"
#include "run/jobs.h"
#include "run/kept.h"
#include "run/progress.h"
#include "run/receipt.h"
#include "run/results.h"
#include "table/typed_read.h"
#include "table/typed_write.h"

/* Blocks at hand keep the threads busy while one is written: a few, and some rows for each. */
static size_t ring_size(const classify_options *o) {
    return 4 + (size_t)jobs_width(o->threads) * 4 * RUN_ROWS / BLOCK_ROWS;
}

typedef struct run_state {
    loaded l;
    csv *points;
    grid *grid;
    jobs *jobs;
    block **ring; /* a block's place is its number modulo the ring's size */
    size_t ring_size;
    unsigned long filled, written; /* blocks */
    unsigned long taken;           /* rows of them, and those that were there already */
    int ended;                     /* all points are taken, or none can be for `read_status` */
    int read_status;
    results table;
    typed_table typed; /* the table, where it is exported */
    int headed;
    progress progress;
} run_state;

/* Lines of the head beside those of the scene: malloc'ed, NULL when out of memory. */
static char *make_head_notes(const run_state *s, const classify_options *o) {
    char shard[64] = "";
    char *grid = s->grid ? grid_notes(s->grid) : strdup("");
    const char *cut = o->scene.solid_flags & GRAZE_SOLID_TRIANGULATE ? "# triangulate yes\n"
                                                                     : "# triangulate no\n";
    if (o->shard.given)
        snprintf(shard, sizeof shard, SHARD_LINE "%lu/%lu\n", o->shard.part.index + 1,
                 o->shard.part.count);
    char *notes = grid ? malloc(strlen(cut) + strlen(grid) + strlen(shard) + 1) : NULL;
    if (notes)
        strcat(strcat(strcpy(notes, cut), grid), shard);
    free(grid);
    return notes;
}

/* Read lines of the table into the columns that are exported. */
static int export_lines(run_state *s, const char *text, size_t length) {
    return complain_of(typed_add(&s->typed, text, length), s->l.context);
}

/* The last column has its name for itself. */
static int check_other_names(const run_state *s, const classify_options *o) {
    const char *others = s->points ? csv_columns(s->points)->others : NULL;
    field rest = {others, others ? strlen(others) : 0}, name;
    while (o->scene.scene.topo && rest.start && field_take(&name, &rest))
        if (field_is(field_content(name), "topo"))
            return complain(EXIT_INPUT,
                            "%s: has a column `topo`; expected another name for it "
                            "beside --topo",
                            o->points);
    return EXIT_DONE;
}

static int put_table_head(run_state *s, const classify_options *o) {
    int named = check_other_names(s, o);
    if (named)
        return named;
    char *notes = make_head_notes(s, o), *text = NULL;
    if (!notes)
        return complain(EXIT_IO, "out of memory");
    graze_status made = graze_report_header(&text, s->l.context, s->l.scene, notes,
                                            s->points ? csv_columns(s->points)->others : NULL);
    int status = complain_of(made, s->l.context);
    if (!status)
        status =
            o->format.table ? export_lines(s, text, strlen(text)) : results_begin(&s->table, text);
    graze_free(text);
    free(notes);
    return status;
}

static int put_run(run_state *s, const classify_options *o, const row_run *one) {
    if (!o->format.table)
        return results_add(&s->table, one->text, one->length, one->done);
    s->table.rows += one->done;
    results_count_undecided(&s->table, one->text, one->length);
    return export_lines(s, one->text, one->length);
}

/* Write the rows of a block that have answers, up to the first that has none. */
static int put_block(run_state *s, const classify_options *o, const block *b) {
    size_t r = 0;
    int status = EXIT_DONE;
    while (r < b->count && !status) {
        const row_run *one = &b->runs[r];
        status = put_run(s, o, one);
        if (!status && one->taken == 0)
            status = EXIT_SIGNAL;
        else if (!status && one->done < one->taken)
            status = fault_tell(&one->fault);
        r += one->taken;
    }
    output_flush(&s->table.out);
    return status;
}

/* Take the next rows, at most `most`, into a block; before the first, write the head of the table.
 */
static int take_block(run_state *s, const classify_options *o, block *b, unsigned long most) {
    int status = EXIT_DONE;
    block_reset(b, s->taken);
    if (s->points)
        s->read_status = csv_fill(s->points, b, most);
    else
        grid_fill(s->grid, o->shard.part, b, most);
    s->ended = s->read_status || b->count == 0;
    int columns_known = !s->read_status || (s->points && csv_columns(s->points)->count);
    if (!s->headed && columns_known && o->format.rows == GRAZE_FORMAT_CSV)
        status = put_table_head(s, o);
    s->headed |= columns_known;
    s->taken += b->count;
    return status;
}

/* Fill the next block and hand it over. */
static int fill_ring(run_state *s, const classify_options *o) {
    block *b = s->ring[s->filled % s->ring_size];
    int status = take_block(s, o, b, BLOCK_ROWS);
    if (status || b->count == 0)
        return status;
    s->filled++;
    jobs_submit(s->jobs, b);
    return EXIT_DONE;
}

/* Rows that a continued table has are not made again; they are checked against their points. */
static int check_kept_rows(run_state *s, const classify_options *o, row_source source) {
    unsigned long rows = results_skip(&s->table);
    int status = EXIT_DONE;
    kept k;
    kept_init(&k, s->l.context, source);
    while (!status && s->taken < rows && !s->ended) {
        status = take_block(s, o, s->ring[0], rows - s->taken);
        if (!status)
            status = interrupt_signal() ? EXIT_SIGNAL : kept_check(&k, &s->table, s->ring[0]);
    }
    kept_clear(&k);
    return status;
}

/* Room for a block, and points that need not be waited for while rows are to be written. */
static int can_fill_ring(run_state *s) {
    unsigned long at_hand = s->filled - s->written;
    return !s->ended && at_hand < s->ring_size && (at_hand == 0 || s->grid || csv_ready(s->points));
}

/* A grid's rows are known; of a file, how much of it is read. */
static portion portion_reached(const run_state *s, const classify_options *o) {
    if (s->points)
        return csv_portion(s->points);
    return (portion){s->table.rows, shard_rows(o->shard.part, grid_count(s->grid))};
}

static int write_next_block(run_state *s, const classify_options *o) {
    const block *b = s->ring[s->written % s->ring_size];
    jobs_wait(s->jobs, b);
    int status = put_block(s, o, b);
    s->written++;
    progress_show(&s->progress, s->table.rows, portion_reached(s, o));
    if (!status && interrupt_signal())
        status = EXIT_SIGNAL;
    return s->table.out.error ? EXIT_IO : status;
}

static int do_all_blocks(run_state *s, const classify_options *o) {
    int status = EXIT_DONE;
    progress_start(&s->progress, o->quiet, s->table.rows, portion_reached(s, o));
    while (!status) {
        while (!status && can_fill_ring(s))
            status = fill_ring(s, o);
        if (status || s->filled == s->written)
            break;
        status = write_next_block(s, o);
    }
    progress_end(&s->progress, s->table.rows, portion_reached(s, o));
    if (!status && s->read_status)
        status = s->read_status == EXIT_SIGNAL ? EXIT_SIGNAL : fault_tell(csv_fault(s->points));
    return status ? status : results_end(&s->table);
}

/* The last lines; those of a shard describe the whole run, so that merge can match the parts. */
static int put_last_lines(run_state *s, const classify_options *o) {
    char text[160];
    if (o->scene.scene.topo) {
        snprintf(text, sizeof text, UNDECIDED_LINE "%lu\n", s->table.undecided);
        int status = o->format.table ? export_lines(s, text, strlen(text)) : EXIT_DONE;
        if (status)
            return status;
        if (!o->format.table)
            output_put(&s->table.out, text);
    }
    if (o->shard.given) {
        snprintf(text, sizeof text, SHARD_ROWS "%lu\n" SHARD_POINTS "%016llx\n",
                 s->grid ? grid_count(s->grid) : csv_rows(s->points),
                 s->grid ? 0 : csv_checksum(s->points));
        output_put(&s->table.out, text);
    }
    snprintf(text, sizeof text, "# complete %lu\n", s->table.rows);
    if (o->format.table)
        return export_lines(s, text, strlen(text));
    output_put(&s->table.out, text);
    return EXIT_DONE;
}

/* The file is read from and written to at once. */
static int check_points_file(const run_state *s, const classify_options *o) {
    const char *option = o->resume ? "--resume" : "--output";
    const char *path = o->resume ? o->resume : o->output;
    if (s->points && path && csv_same_file(s->points, path))
        return complain(EXIT_USAGE, "%s %s: is the file the points are read from", option, path);
    return EXIT_DONE;
}

static int make_ring(run_state *s, size_t size) {
    s->ring = calloc(size, sizeof *s->ring);
    s->ring_size = size;
    for (size_t k = 0; s->ring && k < size; k++)
        if (!(s->ring[k] = block_create()))
            return complain(EXIT_IO, "out of memory");
    return s->ring ? EXIT_DONE : complain(EXIT_IO, "out of memory");
}

static int prepare_run(run_state *s, const classify_options *o) {
    int status = receipt_load(&s->l, o->receipt, &o->scene);
    typed_init(&s->typed, s->l.context);
    if (status)
        return status;
    if (o->grid.sizes)
        status = grid_open(&s->grid, &o->grid, s->l.context, s->l.scene);
    else
        status = csv_open(&s->points, o->points, graze_scene_dimension(s->l.scene), o->shard.part,
                          s->l.context);
    if (!status)
        status = check_points_file(s, o);
    if (!status)
        status = make_ring(s, ring_size(o));
    answer_task task = {
        .context = &o->scene.context,
        .scene = s->l.scene,
        .source = {s->points ? csv_columns(s->points) : NULL, s->grid, o->shard.part},
        .format = o->format.rows};
    if (!status)
        status = jobs_start(&s->jobs, o->threads, &task);
    s->table.counts_undecided = o->scene.scene.topo;
    if (!status)
        status = results_open(&s->table, s->l.context, o->output, o->resume);
    return status ? status : check_kept_rows(s, o, task.source);
}

/* Rows that a signal leaves under way go on until the process ends. */
static void end_run(run_state *s) {
    if (!jobs_stop(s->jobs))
        return;
    for (size_t k = 0; s->ring && k < s->ring_size; k++)
        block_destroy(s->ring[k]);
    free(s->ring);
    csv_close(s->points);
    grid_close(s->grid);
    typed_clear(&s->typed);
    loaded_clear(&s->l);
    free(s);
}

static void put_export_bytes(void *to, const char *bytes, size_t length) {
    output_bytes(to, bytes, length);
}

/* Write the table in the form asked for. */
static int export_table(run_state *s, const classify_options *o) {
    graze_status status = typed_end(&s->typed);
    if (!status)
        status = typed_write(&s->typed, o->format.table, (sink){put_export_bytes, &s->table.out});
    if (status)
        output_drop(&s->table.out);
    return complain_of(status, s->l.context);
}

/* Report the rows that an interrupted run leaves. */
static void report_whole_rows(const run_state *s, const classify_options *o) {
    int is_table = o->format.rows == GRAZE_FORMAT_CSV;
    if (s->table.opened && !o->format.table)
        complain(EXIT_SIGNAL, "%s: has %lu whole rows%s", s->table.out.name, s->table.rows,
                 is_table ? "; the same command with --resume FILE continues a table" : "");
}

int classify_run(const classify_options *o) {
    run_state *s = calloc(1, sizeof *s);
    if (!s)
        return complain(EXIT_IO, "out of memory");
    int status = prepare_run(s, o);
    if (!status)
        status = do_all_blocks(s, o);
    if (!status && o->format.rows == GRAZE_FORMAT_CSV)
        status = put_last_lines(s, o);
    if (!status && o->format.table)
        status = export_table(s, o);
    status = results_close(&s->table, status);
    if (!status && o->scene.scene.topo)
        complain(EXIT_DONE, "note: the position of %lu of %lu rows is undecided",
                 s->table.undecided, s->table.rows);
    if (status == EXIT_SIGNAL)
        report_whole_rows(s, o);
    end_run(s);
    return status;
}
