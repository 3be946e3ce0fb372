/* graze classify: the table.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Points come in blocks, which threads answer while the next ones are read and the last ones
 * written, in order. A failure leaves the whole rows before it and no `# complete` line.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "cli/interrupt.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "cli/rows.h"

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
    "  --limit NAME=V       digits 10000, degree 200, pieces 10000, depth 100, grid 10^10,\n"
    "                       line 10^7, cells 10^8, bytes 4*10^9\n"
    "\n"
    "Example: graze classify cube.off move.json points.csv > table.csv\n";

/* Blocks at hand: enough to keep the threads busy while one is written. */
enum { RING = 4 };

typedef struct run_state {
    loaded l;
    csv *points;
    grid *grid;
    jobs *jobs;
    block *ring[RING];
    unsigned long filled, written; /* blocks */
    unsigned long taken, rows;     /* rows of them */
    int ended;                     /* all points are taken, or none can be for `read_status` */
    int read_status;
    output out;
    int opened, headed;
    progress progress;
} run_state;

static int put_header(run_state *s, const options *o) {
    char *grid = s->grid ? grid_notes(s->grid) : strdup("");
    const char *cut =
        o->solid_flags & GRAZE_SOLID_TRIANGULATE ? "# triangulate yes\n" : "# triangulate no\n";
    char *notes = grid ? malloc(strlen(cut) + strlen(grid) + 1) : NULL;
    char *text = NULL;
    if (!notes) {
        free(grid);
        return complain(EXIT_IO, "out of memory");
    }
    strcpy(notes, cut);
    strcat(notes, grid);
    graze_status status = graze_report_header(&text, s->l.context, s->l.scene, notes,
                                              s->points ? csv_columns(s->points) : NULL);
    if (!status)
        output_put(&s->out, text);
    graze_free(text);
    free(notes);
    free(grid);
    return complain_of(status, s->l.context);
}

/* Write the rows of a block that have answers, up to the first that has none. */
static int put_rows(run_state *s, const block *b) {
    size_t r = 0;
    int status = EXIT_DONE;
    while (r < b->count && !status) {
        const row_run *one = &b->runs[r];
        output_bytes(&s->out, one->text, one->length);
        s->rows += one->done;
        if (one->taken == 0)
            status = EXIT_SIGNAL;
        else if (one->done < one->taken)
            status = fault_tell(&one->fault);
        r += one->taken;
    }
    output_flush(&s->out);
    return status;
}

/* Fill the next block and hand it over; before the first, write the head of the table. */
static int fill(run_state *s, const options *o) {
    block *b = s->ring[s->filled % RING];
    int status = EXIT_DONE;
    block_reset(b, s->taken);
    if (s->points)
        s->read_status = csv_fill(s->points, b);
    else
        grid_fill(s->grid, b);
    s->ended = s->read_status || b->count == 0;
    int columns_known = !s->read_status || (s->points && csv_started(s->points));
    if (!s->headed && columns_known && o->format == GRAZE_FORMAT_CSV)
        status = put_header(s, o);
    s->headed |= columns_known;
    if (status || b->count == 0)
        return status;
    s->taken += b->count;
    s->filled++;
    jobs_submit(s->jobs, b);
    return EXIT_DONE;
}

/* Room for a block, and points that need not be waited for while rows are to be written. */
static int can_fill(run_state *s) {
    unsigned long at_hand = s->filled - s->written;
    return !s->ended && at_hand < RING && (at_hand == 0 || s->grid || csv_ready(s->points));
}

static int write_next(run_state *s) {
    const block *b = s->ring[s->written % RING];
    jobs_wait(s->jobs, b);
    int status = put_rows(s, b);
    s->written++;
    progress_show(&s->progress, s->rows);
    if (!status && interrupt_signal())
        status = EXIT_SIGNAL;
    return s->out.error ? EXIT_IO : status;
}

static int do_blocks(run_state *s, const options *o) {
    int status = EXIT_DONE;
    progress_start(&s->progress);
    while (!status) {
        while (!status && can_fill(s))
            status = fill(s, o);
        if (status || s->filled == s->written)
            break;
        status = write_next(s);
    }
    progress_end(&s->progress, s->rows);
    if (!status && s->read_status)
        status = s->read_status == EXIT_SIGNAL ? EXIT_SIGNAL : fault_tell(csv_fault(s->points));
    return status;
}

static int prepare(run_state *s, const options *o) {
    int status = load(&s->l, o, EXIT_INPUT);
    if (status)
        return status;
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    int threads = (int)(o->jobs ? o->jobs : cores > 0 ? cores : 1);
    if (o->grid)
        status = grid_open(&s->grid, o, s->l.context, s->l.scene);
    else
        status =
            csv_open(&s->points, o->operands[2], graze_scene_dimension(s->l.scene), s->l.context);
    if (!status && s->points && o->output && csv_same_file(s->points, o->output))
        status =
            complain(EXIT_USAGE, "--output %s: is the file the points are read from", o->output);
    for (int k = 0; k < RING && !status; k++)
        if (!(s->ring[k] = block_create()))
            status = complain(EXIT_IO, "out of memory");
    if (!status)
        status = jobs_start(&s->jobs, o, s->l.scene, (row_source){s->points, s->grid}, threads);
    if (!status)
        status = output_open(&s->out, o->output);
    s->opened = !status;
    if (s->opened && o->exported)
        output_keep(&s->out);
    return status;
}

static void finish(run_state *s) {
    jobs_stop(s->jobs);
    for (int k = 0; k < RING; k++)
        block_destroy(s->ring[k]);
    csv_close(s->points);
    grid_close(s->grid);
    unload(&s->l);
    free(s);
}

/* Write the table, which was kept, in the form that was asked for. */
static int export_table(run_state *s, const options *o) {
    size_t length, bytes_length;
    char *table = output_release(&s->out, &length), *bytes = NULL;
    if (!table || s->out.error)
        return EXIT_IO;
    graze_status status =
        graze_report_export(&bytes, &bytes_length, s->l.context, table, length, o->exported);
    if (!status)
        output_bytes(&s->out, bytes, bytes_length);
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
    return EXIT_DONE;
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
    if (!status && o->format == GRAZE_FORMAT_CSV) {
        char line[40];
        snprintf(line, sizeof line, "# complete %lu\n", s->rows);
        output_put(&s->out, line);
    }
    if (!status && o->exported)
        status = export_table(s, o);
    if (s->opened) {
        int closed = output_close(&s->out);
        status = closed ? closed : status;
    }
    finish(s);
    return status;
}

const command command_classify = {"classify", "rltvfpmgbjox", help, run};
