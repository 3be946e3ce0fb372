/* Answers runs of rows: reads their numbers, classifies them and writes them into one text.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "run/answer.h"

#include <string.h>
#include "run/site_answer.h"
#include "run/status.h"

/* Make the points of a run's rows; returns how many before a fault. */
static size_t make_run_points(answerer *a, row_run *r, const block *b, size_t first) {
    const row_source *from = &a->task.source;
    size_t d =
        (size_t)(from->columns ? from->columns->numbers : graze_scene_dimension(a->task.scene));
    size_t n = 0;
    if (from->grid) {
        grid_points(a->points, from->grid, from->part, b->before + first, r->taken);
        return r->taken;
    }
    a->reader.rest_length = 0;
    for (; n < r->taken; n++) {
        a->rest_at[n] = a->reader.rest_length;
        if (columns_row(a->points + n * d, &r->fault, from->columns, &a->reader, b, first + n))
            break;
        a->cell[n] = a->reader.cell;
    }
    /* `rest` is NULL without further columns. */
    for (size_t k = 0; a->reader.rest && k < n; k++)
        a->rest[k] = a->reader.rest + a->rest_at[k];
    return n;
}

/* Write the rows of the first n points, for a table, a certificate or both. */
static graze_status write_answers(answerer *a, row_run *r, size_t n) {
    const answer_task *task = &a->task;
    struct row_text *table = task->no_table ? NULL : &r->out[RESULT_TABLE];
    struct row_text *certificate = &r->out[RESULT_CERTIFICATE];
    const char *const *rest = task->source.columns && task->source.columns->others ? a->rest : NULL;
    if (task->source.columns && task->source.columns->sites.wanted) {
        site_rows rows = {task->source.columns, a->points, a->cell, a->rest, n};
        return site_answer(r, a->context, task->scene, &rows, task->format);
    }
    if (!task->certifier)
        return graze_report_points(&table->text, &table->length, &r->done, a->context, task->scene,
                                   a->points, n, task->format, rest);
    return graze_certificate_points(&certificate->text, &certificate->length,
                                    table ? &table->text : NULL, table ? &table->length : NULL,
                                    &r->done, a->context, task->certifier, a->points, n,
                                    task->format, rest);
}

/* Rows of pmc alone of grid points, many decided together. */
static graze_status write_members(answerer *a, row_run *r, unsigned long first) {
    const row_source *from = &a->task.source;
    struct row_text *table = &r->out[RESULT_TABLE];
    return grid_rows(&table->text, &table->length, &r->done, a->context, from->grid, from->part,
                     first, r->taken);
}

/* Row `row` of the block has no answer. Only a contact point may be the cause itself. */
static void fail_row(answerer *a, row_run *r, graze_status status, const block *b, size_t row) {
    const columns *c = a->task.source.columns;
    const char *why = status == GRAZE_ESYSTEM ? "out of memory" : graze_context_message(a->context);
    if (c && c->sites.wanted)
        fault_set(&r->fault, exit_for(status, status == GRAZE_EINPUT ? EXIT_INPUT : EXIT_FAULT),
                  "%s:%lu: %s", c->name, b->lines[row].number, why);
    else
        fault_set(&r->fault, exit_for(status, EXIT_FAULT), "row %lu: %s",
                  shard_place(a->task.source.part, b->before + row) + 1, why);
}

void answer(answerer *a, row_run *r, const block *b, size_t first) {
    int members = a->task.source.grid && a->task.pmc_alone && !a->task.certifier;
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
    graze_context_destroy(a->context);
}
