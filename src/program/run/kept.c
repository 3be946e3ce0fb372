/* Checks rows that a table or a certificate has already.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/run/kept.h"

#include <string.h>
#include "program/run/site_row.h"

void kept_init(kept *k, graze_context *context, row_source source) {
    memset(k, 0, sizeof *k);
    k->context = k->reader.context = context;
    k->source = source;
    for (int c = 0; c < 4; c++)
        mpq_init(k->point[c]);
}

void kept_clear(kept *k) {
    reader_clear(&k->reader);
    certified_clear(&k->intervals);
    for (int c = 0; c < 4; c++)
        mpq_clear(k->point[c]);
    text_clear(&k->written);
}

/* Make the point of a row of the block: its coordinates as they stand in a row, and its further
 * columns in the reader. */
static int make_point(kept *k, const block *b, size_t index, fault *f) {
    const row_source *from = &k->source;
    int status = EXIT_DONE;
    k->reader.rest_length = 0;
    if (from->grid)
        grid_points(k->point, from->grid, from->part, b->before + index, 1);
    else
        status = columns_row(k->point, f, from->columns, &k->reader, b, index);
    text_clear(&k->written);
    return status || k->form.sites
               ? status
               : row_source_put_point(&k->written, f, from, &k->reader, k->point, k->form.dimension,
                                      k->form.separator, b, index);
}

/* The intervals and contacts of a row. */
static int check_intervals(kept *k, results *t, field word) {
    int status = EXIT_DONE;
    if (!certified_begin(&k->intervals, word))
        return complain(EXIT_IO, "out of memory");
    while (!status && !k->intervals.ended) {
        field line;
        status = results_next(t, &line);
        const char *expected = status ? NULL : certified_line(&k->intervals, &k->form, line);
        if (expected)
            status = results_refuse(t, line, expected, (field){"", 0});
    }
    return status;
}

static int check_row(kept *k, results *t) {
    field row, point = {k->written.data, k->written.length}, rest = {"", 0};
    row_parts parts;
    if (k->form.others)
        rest = (field){k->reader.rest, strlen(k->reader.rest)};
    int status = results_next(t, &row);
    if (status)
        return status;
    const char *expected = row_check(&parts, &k->form, k->context, row);
    if (expected)
        return results_refuse(t, row, expected, (field){"", 0});
    const columns *c = k->source.columns;
    if (k->form.sites && (expected = site_row_fits(&parts, &k->form, c, k->context, k->point)))
        return results_refuse(t, parts.point, expected, (field){"", 0});
    if (!k->form.sites && !field_equal(parts.point, point))
        return results_refuse(t, parts.point, "this run's point, ", point);
    if (!field_equal(parts.rest, rest))
        return results_refuse(t, parts.rest, "this run's further columns, ", rest);
    return t->kind == RESULT_CERTIFICATE ? check_intervals(k, t, parts.word) : EXIT_DONE;
}

int kept_check(kept *k, results *t, const block *b) {
    int status = EXIT_DONE;
    if (!k->form.dimension && !row_form_read(&k->form, t->kind, t->head.data))
        return complain(EXIT_FAULT, "%s: its head is not understood", t->resumed);
    for (size_t r = 0; r < b->count && !status; r++) {
        fault f = {EXIT_DONE, NULL};
        status = make_point(k, b, r, &f);
        if (status)
            fault_tell(&f);
        fault_clear(&f);
        if (!status)
            status = check_row(k, t);
    }
    return status;
}
