/* Answers runs of rows: reads their numbers, classifies them and writes them into one text.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <string.h>
#include "cli/rows.h"

/* Make the points of a run's rows; returns how many before a fault. */
static size_t read_run(answerer *a, row_run *r, const block *b, size_t first) {
    const row_source *from = &a->source;
    size_t d = (size_t)graze_scene_dimension(a->scene), n = 0;
    if (from->grid) {
        grid_points(a->points, from->grid, from->part, b->before + first, r->taken);
        return r->taken;
    }
    a->reader.rest_length = 0;
    for (; n < r->taken; n++) {
        a->rest_at[n] = a->reader.rest_length;
        if (columns_row(a->points + n * d, &r->fault, from->columns, &a->reader, b, first + n))
            break;
    }
    /* Without other columns there is no text of them, and NULL has no places. */
    for (size_t k = 0; a->reader.rest && k < n; k++)
        a->rest[k] = a->reader.rest + a->rest_at[k];
    return n;
}

static int exit_of(graze_status status) {
    return status == GRAZE_ELIMIT ? EXIT_LIMIT : status == GRAZE_ESYSTEM ? EXIT_IO : EXIT_FAULT;
}

void answer(answerer *a, row_run *r, const block *b, size_t first) {
    size_t n = read_run(a, r, b, first);
    int has_rest = a->source.columns && a->source.columns->others;
    graze_status status =
        graze_report_points(&r->text, &r->length, &r->done, a->context, a->scene,
                            (const mpq_t *)a->points, n, a->format, has_rest ? a->rest : NULL);
    if (status)
        fault_clear(&r->fault);
    if (status == GRAZE_ECANCELED)
        r->fault.status = EXIT_SIGNAL;
    else if (status)
        fault_set(&r->fault, exit_of(status), "row %lu: %s",
                  shard_place(a->source.part, b->before + first + r->done) + 1,
                  graze_context_message(a->context));
}

int answerer_init(answerer *a, const options *o, const graze_scene *scene, row_source source) {
    memset(a, 0, sizeof *a);
    a->scene = scene;
    a->source = source;
    a->format = o->format;
    for (size_t p = 0; p < 3 * RUN_ROWS; p++)
        mpq_init(a->points[p]);
    if (context_for(&a->context, o) != GRAZE_OK)
        return complain(EXIT_IO, "out of memory");
    a->reader.context = a->context;
    return EXIT_DONE;
}

void answerer_clear(answerer *a) {
    for (size_t p = 0; p < 3 * RUN_ROWS; p++)
        mpq_clear(a->points[p]);
    reader_clear(&a->reader);
    graze_context_destroy(a->context);
}
