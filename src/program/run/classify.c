/* Classifies points and writes the table, the certificate or both.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Points come in blocks, which threads answer while the next ones are read and the last ones
 * written, in order. A failure leaves the whole rows before it and no `# complete` line.
 */
#include "program/run/results.h"

#include "base/context/scope.h"

/* The number of blocks in memory: enough to keep all threads busy while one block is written. */
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
    unsigned long filled, written; /* numbers of blocks filled and written */
    unsigned long taken;           /* rows taken, with those of an earlier run */
    int ended;                     /* 1: all points are taken, or `read_status` is a failure */
    int read_status;
    results out;
    answer_task task;
    pair_files files;
    int headed;
    progress progress;
} run_state;

static row_source source_of(const run_state *s, const classify_options *o) {
    return (row_source){s->points ? &s->points->columns : NULL, s->grid, o->shard.part,
                        o->coordinates};
}

/* Take the next rows, at most `most`, into a block. Before the first rows the heads are written. */
static int take_block(run_state *s, const classify_options *o, block *b, unsigned long most) {
    int status = EXIT_DONE;
    block_reset(b, s->taken);
    if (s->points)
        s->read_status = csv_fill(s->points, b, most);
    else
        grid_fill(s->grid, o->shard.part, b, most);
    s->ended = s->read_status || b->count == 0;
    int columns_known = !s->read_status || (s->points && s->points->columns.count);
    row_source source = source_of(s, o);
    if (!s->headed && columns_known)
        status = results_begin(&s->out, &source);
    s->headed |= columns_known;
    s->taken += b->count;
    return status || !o->pairs.wanted ? status : pair_files_add(&s->files, &s->task, b);
}

/* Fill the next block and hand it over. */
static int fill_ring(run_state *s, const classify_options *o) {
    block *b = s->ring[s->filled % s->ring_size];
    /* Pairs take long, and are written when their block is answered. */
    TRY(take_block(s, o, b, o->pairs.wanted ? RUN_ROWS : BLOCK_ROWS));
    if (b->count) {
        s->filled++;
        jobs_submit(s->jobs, b);
    }
    return EXIT_DONE;
}

/* Pass over the rows that the record of a continued file counts: their points are read, but the
 * rows are not made again. */
static int pass_kept_rows(run_state *s, const classify_options *o) {
    unsigned long rows = s->out.at.rows;
    unsigned long long points = 0;
    while (s->taken < rows && !s->ended) {
        const block *b = s->ring[0];
        TRY(take_block(s, o, s->ring[0], rows - s->taken));
        points = b->count ? b->points[b->count - 1] : points;
        if (interrupt_signal())
            return EXIT_SIGNAL;
    }
    if (!rows || s->read_status)
        return EXIT_DONE;
    return results_pass(&s->out, s->taken, points);
}

/* Can a further block be filled? There must be room for it and, if rows wait to be written, points
 * that are ready. */
static int can_fill_ring(run_state *s) {
    unsigned long at_hand = s->filled - s->written;
    return !s->ended && at_hand < s->ring_size && (at_hand == 0 || s->grid || csv_ready(s->points));
}

/* How far the run is: for a grid the rows done of all rows, for a file the bytes read. */
static portion portion_reached(run_state *s, const classify_options *o) {
    if (s->points)
        return csv_portion(s->points);
    return (portion){results_main(&s->out)->rows, shard_rows(o->shard.part, s->grid->count)};
}

static int write_next_block(run_state *s, const classify_options *o) {
    const block *b = s->ring[s->written % s->ring_size];
    jobs_wait(s->jobs, b);
    int status = results_block(&s->out, b);
    s->written++;
    progress_show(&s->progress, results_main(&s->out)->rows, portion_reached(s, o));
    if (!status && interrupt_signal())
        status = EXIT_SIGNAL;
    return results_failed(&s->out) ? EXIT_IO : status;
}

static int do_all_blocks(run_state *s, const classify_options *o) {
    int status = EXIT_DONE;
    progress_start(&s->progress, o->quiet, results_main(&s->out)->rows, portion_reached(s, o));
    while (!status) {
        while (!status && can_fill_ring(s))
            status = fill_ring(s, o);
        if (status || s->filled == s->written)
            break;
        status = write_next_block(s, o);
    }
    progress_end(&s->progress, results_main(&s->out)->rows, portion_reached(s, o));
    if (!status && s->read_status)
        status = s->read_status == EXIT_SIGNAL ? EXIT_SIGNAL : fault_tell(&s->points->fault);
    return status ? status : result_end(results_main(&s->out));
}

static int make_ring(run_state *s, size_t size) {
    s->ring = calloc(size, sizeof *s->ring);
    s->ring_size = size;
    for (size_t k = 0; s->ring && k < size; k++)
        if (!(s->ring[k] = block_create()))
            return complain(EXIT_IO, "out of memory");
    return s->ring ? EXIT_DONE : complain(EXIT_IO, "out of memory");
}

/* Load the scene, prepare the results, and load a certifier if a certificate is to be written. */
static int load_scene(run_state *s, const classify_options *o) {
    int certified = o->no_table || o->certificate;
    s->l.rows = o->scene.rows; /* pairs have no scene */
    int status = o->pairs.wanted ? context_make(&s->l.context, &o->scene.context)
                 : o->known      ? EXIT_DONE
                                 : receipt_load(&s->l, o->receipt, &o->scene);
    if (o->known) {
        s->l = *o->known;
        *o->known = (loaded){.context = NULL};
    }
    if (!status && o->sites.wanted)
        status = load_takes(s->l.solid, o->scene.solid, "contact", TAKES_STRAIGHT);
    results_init(&s->out, o, &s->l);
    return !status && certified ? certified_load(&s->l, o, 1) : status;
}

static int prepare_run(run_state *s, const classify_options *o) {
    TRY(load_scene(s, o));
    TRY(o->grid.sizes ? grid_open(&s->grid, &o->grid, s->l.context, s->l.scene)
                      : csv_open(&s->points, o->points, o->in_memory,
                                 graze_scene_dimension(s->l.scene), o->shard.part, s->l.context));
    if (o->sites.wanted)
        csv_expect_sites(s->points, o->sites.snap);
    if (o->pairs.wanted) {
        csv_expect_pairs(s->points);
        TRY(pair_files_check(o, s->l.context));
    }
    TRY(make_ring(s, ring_size(o)));
    s->task = (answer_task){.context = &o->scene.context,
                            .scene = s->l.scene,
                            .certifier = s->l.certifier,
                            .no_table = o->no_table,
                            .rows = &s->l.rows,
                            .pairs = o->pairs.wanted ? o : NULL,
                            .source = source_of(s, o),
                            .one_by_one = graze_solid_primitive_count(s->l.solid) > 0};
    s->files.context = s->l.context;
    TRY(jobs_start(&s->jobs, o->threads, &s->task));
    TRY(results_open(&s->out));
    return pass_kept_rows(s, o);
}

/* End the threads and free the blocks. If a signal left threads at work, nothing is freed, and the
 * end of the process ends them. */
static void end_run(run_state *s) {
    if (!jobs_stop(s->jobs))
        return;
    for (size_t k = 0; s->ring && k < s->ring_size; k++)
        block_destroy(s->ring[k]);
    free(s->ring);
    csv_close(s->points);
    grid_close(s->grid);
    pairs_end();
    pair_files_clear(&s->files);
    loaded_clear(&s->l);
    free(s);
}

int classify_run(const classify_options *o) {
    run_state *s = calloc(1, sizeof *s);
    if (!s)
        return complain(EXIT_IO, "out of memory");
    int status = prepare_run(s, o);
    if (!status)
        status = do_all_blocks(s, o);
    if (!status)
        status = results_end(&s->out, s->grid ? s->grid->count : s->points->rows,
                             s->grid ? 0 : checksum_value(&s->points->sum));
    if (!status && s->points && !s->points->rows)
        complain(EXIT_DONE, "note: %s has no %s", s->points->columns.name,
                 o->pairs.wanted ? "pairs" : "points");
    status = results_close(&s->out, status);
    if (!status && o->pairs.wanted)
        status = s->out.at.undecided ? EXIT_INPUT : s->out.at.wide ? EXIT_NO : EXIT_DONE;
    end_run(s);
    return status;
}
