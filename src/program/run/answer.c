/* Hands rows out to threads or ranks, and answers runs of rows: reads their numbers, classifies
 * them and writes them into one text. A contact point is a site of the scene, and a row.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/run/results.h"

#include "base/context/scope.h"

void queue_add(queue *q, block *b) {
    if (q->first)
        q->last->after = b;
    else
        q->first = b;
    q->last = b;
    q->left += b->count;
}

size_t queue_take(queue *q, block **of, int workers, size_t most) {
    block *b = *of = q->first;
    size_t first = b->next, in_block = b->count - first;
    size_t share = q->left / (4 * (size_t)workers);
    share = share < 1 ? 1 : share < most ? share : most;
    share = share < in_block ? share : in_block;
    b->runs[first] = (row_run){.taken = share, .fault = {EXIT_SIGNAL, NULL}};
    b->next += share;
    b->busy++;
    q->left -= share;
    if (share == in_block)
        q->first = b->after;
    return first;
}

/* Name the place of a row for messages. */
static void put_place(text *out, const row_source *from, const block *b, size_t row) {
    if (from->grid)
        text_format(out, "row %lu", shard_place(from->part, b->before + row) + 1);
    else
        text_format(out, "%s:%lu", from->columns->name, b->lines[row].number);
}

/* Write the coordinates of a run's point, unless its row has exact ones. */
static int write_point(answerer *a, row_run *r, const block *b, size_t first, size_t n) {
    const row_source *from = &a->task.source;
    int d = graze_scene_dimension(a->task.scene);
    field tokens[3] = {{NULL, 0}, {NULL, 0}, {NULL, 0}};
    if (from->coordinates.form == COORDINATES_EXACT)
        return EXIT_DONE;
    HELD(text, place);
    for (int k = 0; !from->grid && k < d; k++)
        tokens[k] = field_content(a->reader.cut.item[from->columns->where[k]]);
    if (from->coordinates.form == COORDINATES_DECIMAL)
        put_place(&place, from, b, first + n);
    a->written.failed |= place.failed;
    TRY(coordinates_put(&a->written, &r->fault, &from->coordinates, a->reader.context,
                        a->points + n * (size_t)d, d, tokens, place.data ? place.data : ""));
    text_bytes(&a->written, "", 1);
    return EXIT_DONE;
}

/* Make the points and the texts of a run's rows; returns how many rows there are before a fault. */
static size_t make_run_points(answerer *a, row_run *r, const block *b, size_t first) {
    const row_source *from = &a->task.source;
    size_t d =
        (size_t)(from->columns ? from->columns->numbers : graze_scene_dimension(a->task.scene));
    size_t n = 0, point_at[RUN_ROWS] = {0}, rest_at[RUN_ROWS] = {0};
    if (from->grid)
        graze_grid_points(a->points, from->grid->points, shard_place(from->part, b->before + first),
                          from->part.count, r->taken);
    a->reader.rest.length = 0;
    for (; n < r->taken; n++) {
        point_at[n] = a->written.length;
        rest_at[n] = a->reader.rest.length;
        if (!from->grid &&
            columns_row(a->points + n * d, &r->fault, from->columns, &a->reader, b, first + n))
            break;
        if (write_point(a, r, b, first, n))
            break;
        a->cell[n] = a->reader.cell;
    }
    for (size_t k = 0; k < n; k++) {
        a->texts[k].point = a->written.length ? a->written.data + point_at[k] : NULL;
        a->texts[k].rest =
            from->columns && from->columns->others ? a->reader.rest.data + rest_at[k] : NULL;
    }
    return n;
}

static graze_status make_site(graze_site **out, const answerer *a, size_t row) {
    const columns *c = a->task.source.columns;
    graze_rationals number = (graze_rationals)a->points + row * (size_t)c->numbers;
    if (c->sites.snap)
        return (c->sites.in_world ? graze_site_snap_at : graze_site_snap)(
            out, a->context, a->task.scene, number[0], number + 1, a->cell[row]);
    return (c->sites.in_world ? graze_site_create_at : graze_site_create)(
        out, a->context, a->task.scene, number[0], number + 1);
}

static graze_status add_site_row(text *out, const answerer *a, size_t row) {
    OWNED(graze_site, site);
    char *line = NULL;
    TRY(make_site(&site, a, row));
    TRY(graze_site_row(&line, a->context, site, a->task.rows->format, a->texts[row].rest));
    text_put(out, line);
    graze_free(line);
    return GRAZE_OK;
}

/* Write the rows of the first n contact points as one text. */
static graze_status write_sites(answerer *a, row_run *r, size_t n) {
    struct row_text *table = &r->out[RESULT_TABLE];
    graze_status status = GRAZE_OK;
    HELD(text, all);
    while (r->done < n && !status) {
        status = add_site_row(&all, a, r->done);
        r->done += !status;
    }
    table->length = all.length;
    if (all.failed)
        r->done = 0;
    table->text = text_take(&all);
    return table->text || status ? status : GRAZE_ESYSTEM;
}

/* Write the rows of the first n points, for a table, a certificate or both. */
static graze_status write_answers(answerer *a, row_run *r, size_t n) {
    const answer_task *task = &a->task;
    struct row_text *table = task->no_table ? NULL : &r->out[RESULT_TABLE];
    struct row_text *certificate = &r->out[RESULT_CERTIFICATE];
    if (task->source.columns && task->source.columns->sites.wanted)
        return write_sites(a, r, n);
    if (!task->certifier)
        return graze_report_points(&table->text, &table->length, &r->done, &r->totals, a->context,
                                   task->scene, a->points, n, a->texts, task->rows);
    return graze_certificate_points(&certificate->text, &certificate->length,
                                    table ? &table->text : NULL, table ? &table->length : NULL,
                                    &r->done, &r->totals, a->context, task->certifier, a->points, n,
                                    a->texts, task->rows);
}

/* Write rows of a grid with pmc alone. Many of its points are decided together. */
static graze_status write_members(answerer *a, row_run *r, unsigned long first) {
    const row_source *from = &a->task.source;
    struct row_text *table = &r->out[RESULT_TABLE];
    return graze_grid_rows(&table->text, &table->length, &r->done, a->context, from->grid->points,
                           shard_place(from->part, first), from->part.count, r->taken,
                           a->task.rows->format);
}

/* Set the fault of a row that has no answer. Only GRAZE_EINPUT is a fault of the file of points. */
static void fail_row(answerer *a, row_run *r, graze_status status, const block *b, size_t row) {
    const columns *c = a->task.source.columns;
    const char *why = status == GRAZE_ESYSTEM ? "out of memory" : graze_context_message(a->context);
    int code = exit_for(status, status == GRAZE_EINPUT ? EXIT_INPUT : EXIT_FAULT);
    if (c && c->sites.wanted)
        fault_set(&r->fault, code, "%s:%lu: %s", c->name, b->lines[row].number, why);
    else
        fault_set(&r->fault, code, "row %lu: %s",
                  shard_place(a->task.source.part, b->before + row) + 1, why);
}

static int asks_for_members(const answer_task *task) {
    return task->source.grid && !task->one_by_one && task->rows->columns == GRAZE_COLUMNS_PMC &&
           !(task->rows->sdf > 0) && !task->certifier &&
           task->source.coordinates.form == COORDINATES_EXACT;
}

size_t answer_most(const answer_task *task) {
    return task->pairs ? 1 : asks_for_members(task) ? BLOCK_ROWS : RUN_ROWS;
}

void answer(answerer *a, row_run *r, const block *b, size_t first) {
    if (a->task.pairs) {
        answer_pair(a, r, b, first);
        return;
    }
    int members = asks_for_members(&a->task);
    text_clear(&a->written);
    size_t n = members ? 0 : make_run_points(a, r, b, first);
    graze_status status = members ? write_members(a, r, b->before + first) : write_answers(a, r, n);
    if (status)
        fault_clear(&r->fault);
    if (status == GRAZE_ECANCELED)
        r->fault.status = EXIT_SIGNAL;
    else if (status)
        fail_row(a, r, status, b, first + r->done);
}

int answerer_init(answerer *a, const answer_task *task) {
    memset(a, 0, sizeof *a);
    a->task = *task;
    for (size_t p = 0; p < 4 * RUN_ROWS; p++)
        mpq_init(a->points[p]);
    int status = context_make(&a->context, task->context);
    a->reader.context = a->context;
    return status;
}

void answerer_clear(answerer *a) {
    for (size_t p = 0; p < 4 * RUN_ROWS; p++)
        mpq_clear(a->points[p]);
    reader_clear(&a->reader);
    text_clear(&a->written);
    graze_context_destroy(a->context);
}
