/* Points to be drawn: those of a file, named by its column id, and those of options.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdio.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "program/cli/values.h"

void marks_clear(marks *m) {
    for (size_t k = 0; k < m->values; k++)
        mpq_clear(m->value[k]);
    for (size_t k = 0; k < m->count; k++) {
        free(m->name[k]);
        free(m->stratum[k]);
    }
    free(m->value);
    free(m->name);
    free(m->stratum);
}

/* Make room for one more point; 0 when out of memory. */
static int marks_grow(marks *m) {
    size_t values = (m->count + 1) * (size_t)m->dimension;
    if (!array_reserve(&m->name, &m->capacity, m->count + 1, sizeof *m->name) ||
        !array_reserve(&m->stratum, &m->stratum_capacity, m->count + 1, sizeof *m->stratum) ||
        !array_reserve(&m->value, &m->value_capacity, values, sizeof *m->value))
        return 0;
    for (; m->values < values; m->values++)
        mpq_init(m->value[m->values]);
    return 1;
}

/* Add the point whose numbers were put at the end of `value`; its malloc'ed name and stratum are
 * taken over. */
static int marks_take(marks *m, char *name, char *stratum) {
    if (!name) {
        free(stratum);
        return complain(EXIT_IO, "out of memory");
    }
    m->name[m->count] = name;
    m->stratum[m->count++] = stratum;
    return EXIT_DONE;
}

/* The text `before` followed by a number, malloc'ed. */
static char *number_name(const char *before, size_t number) {
    char text[32];
    snprintf(text, sizeof text, "%s%zu", before, number);
    return strdup(text);
}

/* Find the further column with a name; *found is -1 if there is none. Returns 0 when out of memory.
 */
static int mark_column(long *found, const char *columns, const char *name) {
    ZEROED(fields, cut);
    *found = -1;
    fields_result result =
        columns ? fields_cut(&cut, (field){columns, strlen(columns)}) : FIELDS_CUT;
    for (size_t k = cut.count; k-- > 0;) {
        field f = field_content(cut.item[k]);
        if (f.length == strlen(name) && memcmp(f.start, name, f.length) == 0)
            *found = (long)k;
    }
    return result != FIELDS_NO_MEMORY;
}

/* The content of a further column of a row; NULL if the row lacks it or when out of memory. */
static char *mark_field(const char *rest, long column) {
    ZEROED(fields, cut);
    if (fields_cut(&cut, (field){rest, strlen(rest)}) != FIELDS_CUT || (size_t)column >= cut.count)
        return NULL;
    field f = field_content(cut.item[column]);
    return strndup(f.start, f.length);
}

static int read_marks_block(marks *m, csv *points, const block *b, graze_context *context) {
    ZEROED(fault, f);
    ZEROED(reader, r);
    r.context = context;
    long id, stratum = -1;
    const char *others = points->columns.others;
    if (!mark_column(&id, others, "id") || !mark_column(&stratum, others, "stratum"))
        return complain(EXIT_IO, "out of memory");
    for (size_t k = 0; k < b->count; k++) {
        r.rest.length = 0;
        if (!marks_grow(m))
            return complain(EXIT_IO, "out of memory");
        if (columns_row(m->value + m->count * (size_t)m->dimension, &f, &points->columns, &r, b, k))
            return fault_tell(&f);
        TRY(marks_take(m, id < 0 ? number_name("", m->count + 1) : mark_field(r.rest.data, id),
                       stratum < 0 ? NULL : mark_field(r.rest.data, stratum)));
    }
    return EXIT_DONE;
}

int marks_read(marks *m, const char *path, graze_context *context) {
    csv *points = NULL;
    block *b = block_create();
    int status = b ? csv_open(&points, path, NULL, m->dimension, (shard){0, 1}, context)
                   : complain(EXIT_IO, "out of memory");
    for (int more = 1; more && !status;) {
        block_reset(b, 0);
        int read = csv_fill(points, b, BLOCK_ROWS);
        more = b->count > 0;
        status = read_marks_block(m, points, b, context);
        if (!status && read)
            status = read == EXIT_SIGNAL ? EXIT_SIGNAL : fault_tell(&points->fault);
    }
    csv_close(points);
    block_destroy(b);
    return status;
}

int marks_take_points(marks *m, const char *const *points, int count, graze_context *context) {
    for (int k = 0; k < count; k++) {
        if (!marks_grow(m))
            return complain(EXIT_IO, "out of memory");
        TRY(numbers_given(m->value + m->count * (size_t)m->dimension, context, "-p", points[k],
                          m->dimension));
        TRY(marks_take(m, count > 1 ? number_name("P", (size_t)k + 1) : strdup("P"), NULL));
    }
    return EXIT_DONE;
}

void marks_give(graze_draw_options *out, const marks *m) {
    out->points = m->value;
    out->point_count = m->count;
    out->names = (const char *const *)m->name;
    out->strata = (const char *const *)m->stratum;
}
