/* graze classify: the table.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Points come in blocks, which threads answer while the next ones are read and the last ones
 * written, in order. A failure leaves the whole rows before it and no `# complete` line.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cli/interrupt.h"
#include "cli/kept.h"
#include "cli/rows.h"
#include "cli/receipt.h"
#include "cli/results.h"

static const char help[] =
    "graze classify SOLID MOTION POINTS: in, on, out and the class of each point, exactly\n"
    "\n"
    "POINTS is a CSV file or - for standard input; a header may name x, y, z among other columns,\n"
    "which are kept. Numbers: -12, 0.1, 1.5e-3, 22/7, all exact.\n"
    "\n"
    "  --grid NX,NY[,NZ]    a grid of points instead of POINTS, each number at least 2\n"
    "  --box x0,y0[,z0],x1,y1[,z1]   the grid's corners; default: a box around the sweep\n"
    "  --operation sweep|unsweep     the set points are classified against (sweep)\n"
    "  --overlap extend|reject       S^0 and S^1 that meet: nine cases (default), or an error\n"
    "  --folds separate|combined     Definitions 6 and 7 (default), or 10 and 11\n"
    "  --format csv|jsonl   a table (default; whole only with its last line # complete N), or a\n"
    "                       line of JSON per point with its contacts\n"
    "  --format vtk|npy     the table as a legacy VTK file or a structured numpy array\n"
    "  --round none|binary64|binary32   round every number read to the nearest such float\n"
    "  --triangulate        fan facets that are not planar from their first vertex\n"
    "  --jobs N             threads (default: all cores); the output is the same for any N\n"
    "  --no-filter          the exact path alone: the same answers, slower\n"
    "  --output FILE        write there instead of to standard output\n"
    "  --resume FILE        continue the table in FILE, if there is one, after its last whole row\n"
    "  --shard i/n          rows i, i + n, i + 2n, ... only; graze merge makes one table of them\n"
    "  --receipt FILE       spare the validation of a solid that graze check --receipt has done\n"
    "  --quiet              no progress on the terminal\n"
    "  --limit NAME=V       digits 10000, degree 200, pieces 10000, depth 100, grid 10^10,\n"
    "                       line 10^7, cells 10^8, bytes 4*10^9\n"
    "\n"
    "Example: graze classify cube.off move.json points.csv > table.csv\n";

/* Blocks at hand keep the threads busy while one is written: a few, and some rows for each. */
static size_t ring_size(const options *o) {
    return 4 + (size_t)jobs_width(o) * 4 * RUN_ROWS / BLOCK_ROWS;
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
    int headed;
    progress progress;
} run_state;

/* The lines of the head that the scene does not know of: malloc'ed, NULL when out of memory. */
static char *make_notes(const run_state *s, const options *o) {
    char shard[64] = "";
    char *grid = s->grid ? grid_notes(s->grid) : strdup("");
    const char *cut =
        o->solid_flags & GRAZE_SOLID_TRIANGULATE ? "# triangulate yes\n" : "# triangulate no\n";
    if (o->sharded)
        snprintf(shard, sizeof shard, SHARD_LINE "%lu/%lu\n", o->part.index + 1, o->part.count);
    char *notes = grid ? malloc(strlen(cut) + strlen(grid) + strlen(shard) + 1) : NULL;
    if (notes)
        strcat(strcat(strcpy(notes, cut), grid), shard);
    free(grid);
    return notes;
}

static int put_header(run_state *s, const options *o) {
    char *notes = make_notes(s, o), *text = NULL;
    if (!notes)
        return complain(EXIT_IO, "out of memory");
    graze_status made = graze_report_header(&text, s->l.context, s->l.scene, notes,
                                            s->points ? csv_columns(s->points)->others : NULL);
    int status = made ? complain_of(made, s->l.context) : results_begin(&s->table, text);
    graze_free(text);
    free(notes);
    return status;
}

/* Write the rows of a block that have answers, up to the first that has none. */
static int put_rows(run_state *s, const block *b) {
    size_t r = 0;
    int status = EXIT_DONE;
    while (r < b->count && !status) {
        const row_run *one = &b->runs[r];
        status = results_add(&s->table, one->text, one->length, one->done);
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
static int take(run_state *s, const options *o, block *b, unsigned long most) {
    int status = EXIT_DONE;
    block_reset(b, s->taken);
    if (s->points)
        s->read_status = csv_fill(s->points, b, most);
    else
        grid_fill(s->grid, o->part, b, most);
    s->ended = s->read_status || b->count == 0;
    int columns_known = !s->read_status || (s->points && csv_columns(s->points)->count);
    if (!s->headed && columns_known && o->format == GRAZE_FORMAT_CSV)
        status = put_header(s, o);
    s->headed |= columns_known;
    s->taken += b->count;
    return status;
}

/* Fill the next block and hand it over. */
static int fill(run_state *s, const options *o) {
    block *b = s->ring[s->filled % s->ring_size];
    int status = take(s, o, b, BLOCK_ROWS);
    if (status || b->count == 0)
        return status;
    s->filled++;
    jobs_submit(s->jobs, b);
    return EXIT_DONE;
}

/* The rows that a continued table has are not made again, but held to their points. */
static int check_kept(run_state *s, const options *o, row_source source) {
    unsigned long rows = results_skip(&s->table);
    int status = EXIT_DONE;
    kept k;
    kept_init(&k, s->l.context, source);
    while (!status && s->taken < rows && !s->ended) {
        status = take(s, o, s->ring[0], rows - s->taken);
        if (!status)
            status = interrupt_signal() ? EXIT_SIGNAL : kept_check(&k, &s->table, s->ring[0]);
    }
    kept_clear(&k);
    return status;
}

/* Room for a block, and points that need not be waited for while rows are to be written. */
static int can_fill(run_state *s) {
    unsigned long at_hand = s->filled - s->written;
    return !s->ended && at_hand < s->ring_size && (at_hand == 0 || s->grid || csv_ready(s->points));
}

/* A grid's rows are known; of a file, how much of it is read. */
static portion reached(const run_state *s, const options *o) {
    if (s->points)
        return csv_portion(s->points);
    return (portion){s->table.rows, shard_rows(o->part, grid_count(s->grid))};
}

static int write_next(run_state *s, const options *o) {
    const block *b = s->ring[s->written % s->ring_size];
    jobs_wait(s->jobs, b);
    int status = put_rows(s, b);
    s->written++;
    progress_show(&s->progress, s->table.rows, reached(s, o));
    if (!status && interrupt_signal())
        status = EXIT_SIGNAL;
    return s->table.out.error ? EXIT_IO : status;
}

static int do_blocks(run_state *s, const options *o) {
    int status = EXIT_DONE;
    progress_start(&s->progress, o->quiet, s->table.rows, reached(s, o));
    while (!status) {
        while (!status && can_fill(s))
            status = fill(s, o);
        if (status || s->filled == s->written)
            break;
        status = write_next(s, o);
    }
    progress_end(&s->progress, s->table.rows, reached(s, o));
    if (!status && s->read_status)
        status = s->read_status == EXIT_SIGNAL ? EXIT_SIGNAL : fault_tell(csv_fault(s->points));
    return status ? status : results_end(&s->table);
}

/* The last lines: a shard's say what the whole run was, so that its parts are known to match. */
static void put_end(run_state *s, const options *o) {
    char text[160];
    if (o->sharded) {
        snprintf(text, sizeof text, SHARD_ROWS "%lu\n" SHARD_POINTS "%016llx\n",
                 s->grid ? grid_count(s->grid) : csv_rows(s->points),
                 s->grid ? 0 : csv_checksum(s->points));
        output_put(&s->table.out, text);
    }
    snprintf(text, sizeof text, "# complete %lu\n", s->table.rows);
    output_put(&s->table.out, text);
}

/* The file is read from and written to at once. */
static int check_files(const run_state *s, const options *o) {
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

static int prepare(run_state *s, const options *o) {
    int status = o->receipt ? receipt_load(&s->l, o) : load(&s->l, o, EXIT_INPUT, NULL);
    if (status)
        return status;
    if (o->grid)
        status = grid_open(&s->grid, o, s->l.context, s->l.scene);
    else
        status = csv_open(&s->points, o->operands[2], graze_scene_dimension(s->l.scene), o->part,
                          s->l.context);
    if (!status)
        status = check_files(s, o);
    if (!status)
        status = make_ring(s, ring_size(o));
    row_source source = {s->points ? csv_columns(s->points) : NULL, s->grid, o->part};
    if (!status)
        status = jobs_start(&s->jobs, o, s->l.scene, source);
    if (!status)
        status = results_open(&s->table, o->output, o->resume);
    if (!status && o->exported)
        output_keep(&s->table.out);
    return status ? status : check_kept(s, o, source);
}

static void finish(run_state *s) {
    jobs_stop(s->jobs);
    for (size_t k = 0; s->ring && k < s->ring_size; k++)
        block_destroy(s->ring[k]);
    free(s->ring);
    csv_close(s->points);
    grid_close(s->grid);
    unload(&s->l);
    free(s);
}

/* Write the table, which was kept, in the form that was asked for. */
static int export_table(run_state *s, const options *o) {
    size_t length, bytes_length;
    char *table = output_release(&s->table.out, &length), *bytes = NULL;
    if (!table || s->table.out.error)
        return EXIT_IO;
    graze_status status =
        graze_report_export(&bytes, &bytes_length, s->l.context, table, length, o->exported);
    if (!status)
        output_bytes(&s->table.out, bytes, bytes_length);
    free(table);
    graze_free(bytes);
    return complain_of(status, s->l.context);
}

static int check_usage(const options *o) {
    int wanted = o->grid ? 2 : 3;
    if (o->box && !o->grid)
        return complain(EXIT_USAGE, "--box goes with --grid; see graze classify --help");
    if (o->operand_count != wanted)
        return complain(EXIT_USAGE,
                        "classify takes SOLID, MOTION and %s, %d operands given; see graze "
                        "classify --help",
                        o->grid ? "with --grid no POINTS" : "POINTS or --grid", o->operand_count);
    if (o->resume && o->output)
        return complain(EXIT_USAGE,
                        "--resume FILE writes to FILE; --output has no place beside it");
    if ((o->resume || o->sharded) && (o->format != GRAZE_FORMAT_CSV || o->exported))
        return complain(EXIT_USAGE, "%s takes the head of a table; right is --format csv",
                        o->resume ? "--resume" : "--shard");
    return EXIT_DONE;
}

/* What an interrupted run leaves. */
static void tell_rows(const run_state *s, const options *o) {
    int is_table = o->format == GRAZE_FORMAT_CSV;
    if (s->table.opened && !o->exported)
        complain(EXIT_SIGNAL, "%s: has %lu whole rows%s", s->table.out.name, s->table.rows,
                 is_table ? "; the same command with --resume FILE continues a table" : "");
}

static int run(const options *o) {
    int status = check_usage(o);
    if (status)
        return status;
    run_state *s = calloc(1, sizeof *s);
    if (!s)
        return complain(EXIT_IO, "out of memory");
    status = prepare(s, o);
    if (!status)
        status = do_blocks(s, o);
    if (!status && o->format == GRAZE_FORMAT_CSV)
        put_end(s, o);
    if (!status && o->exported)
        status = export_table(s, o);
    status = results_close(&s->table, status);
    if (status == EXIT_SIGNAL)
        tell_rows(s, o);
    finish(s);
    return status;
}

const command command_classify = {"classify", "rltvfpmgbjoxQRNY", help, run};
