/* Reads points from CSV and .npy files in blocks (src/program/cli/formats.md, Points).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Lines are found here and read later (columns_row); lines of other shards are only counted. One
 * buffer of the file and one block are in memory.
 */
#include "program/points/heads.h"

#include <sys/stat.h>
#include "base/context/scope.h"
#include "output/report/columns.h"

int csv_open(csv **out, const char *path, const char *in_memory, int dimension, shard part,
             graze_context *context) {
    struct stat about;
    csv *c = calloc(1, sizeof *c);
    *out = c;
    if (!c)
        return complain(EXIT_IO, "out of memory");
    int status = in_memory ? EXIT_DONE : complain_of(stream_open(&c->in, context, path), context);
    if (in_memory)
        stream_of_text(&c->in, context, path, in_memory, strlen(in_memory));
    c->columns = (columns){.name = c->in.name, .dimension = dimension, .numbers = dimension};
    c->part = part;
    if (!status && fstat(c->in.fd, &about) == 0 && S_ISREG(about.st_mode) && about.st_size > 0)
        c->size = (unsigned long)about.st_size;
    c->is_array = !status && npy_is(c->in.fd, c->in.name);
    return status;
}

void csv_expect_sites(csv *c, int snap) {
    c->columns.sites = (site_form){.wanted = 1, .snap = snap, .dimension = c->columns.dimension};
    c->columns.numbers = c->columns.dimension + 1;
}

void csv_expect_pairs(csv *c) {
    c->columns.pairs.wanted = 1;
}

void csv_close(csv *c) {
    if (!c)
        return;
    npy_close(c->array);
    stream_close(&c->in);
    fault_clear(&c->fault);
    columns_clear(&c->columns);
    free(c);
}

portion csv_portion(const csv *c) {
    return c->array ? (portion){c->array->done, c->array->head.rows}
                    : (portion){(unsigned long)c->in.offset, c->size};
}

static int skipped(field text) {
    return (text.length && *text.start == '#') || field_trimmed(text).length == 0;
}

static void add_to_checksum(csv *c, field line) {
    checksum_add(&c->sum, line.start, line.length);
    checksum_add(&c->sum, "\n", 1);
}

/* Put a row into the block, if it is one of the shard. */
static int take_row(csv *c, block *b, field text) {
    unsigned long row = c->rows++;
    add_to_checksum(c, text);
    if (row % c->part.count != c->part.index)
        return EXIT_DONE;
    if (!block_add(b, text, c->in.line))
        return fault_set(&c->fault, EXIT_IO, "out of memory");
    b->points[b->count - 1] = checksum_value(&c->sum);
    return EXIT_DONE;
}

/* Take a line that is neither blank nor a comment; the first such line fixes the columns. */
static int take_point_line(csv *c, block *b, field text) {
    int header = 0, status = EXIT_DONE;
    if (!c->columns.count)
        status =
            columns_fix(&header, &c->fault, &c->columns, c->in.context, text, c->in.line, c->head);
    if (!status && header)
        add_to_checksum(c, text);
    return status || header ? status : take_row(c, b, text);
}

int csv_ready(csv *c) {
    return c->is_array || stream_ready(&c->in);
}

/* Read the next line of the file, or the next row of an array as a line. */
static int next_point_line(csv *c, field *line) {
    if (!c->is_array)
        return fault_of(&c->fault, stream_next(&c->in, line), c->in.context, EXIT_INPUT);
    if (columns_are_named(&c->columns))
        return names_fault(&c->fault, &c->columns, 1, "a .npy file has no names");
    if (!c->array)
        TRY(npy_open(&c->array, &c->fault, c->in.context, c->in.fd, c->in.name,
                     c->columns.dimension));
    TRY(npy_next(c->array, &c->fault, line));
    c->in.line = c->array->done;
    return EXIT_DONE;
}

/* A `#` line before the first row: does it say that Graze has written the file? */
static void read_head_line(csv *c, field text) {
    field version;
    c->head.graze |= c->in.line == 1 && field_behind(&version, text, "# graze ");
    c->head.sets |= columns_of_line(text);
    c->head.unsweep |= field_is(text, "# operation unsweep");
    c->head.pmc_alone |= field_is(text, "# columns pmc");
}

/* A block also ends when no further line is ready, so that the threads that answer its rows need
 * not wait. */
int csv_fill(csv *c, block *b, unsigned long most) {
    int status = EXIT_DONE;
    while (!status && b->count < BLOCK_ROWS && b->count < most && b->used < BLOCK_BYTES &&
           (b->count == 0 || csv_ready(c))) {
        field text;
        status = next_point_line(c, &text);
        if (!status && !text.start) {
            if (columns_are_named(&c->columns) && !c->columns.count)
                status = names_fault(&c->fault, &c->columns, c->in.line, "the file is empty");
            break;
        }
        if (!status && !skipped(text))
            status = take_point_line(c, b, text);
        else if (!status && !c->columns.count)
            read_head_line(c, text);
    }
    return status;
}
