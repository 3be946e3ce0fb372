/* Reads a part of a table or a certificate (part.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/run/part.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "program/run/status.h"

/* The last lines are within so many bytes of the end. */
enum { TAIL = 256 };

static int next_line(part *p, field *line) {
    return complain_of(stream_next(&p->in, line), p->in.context);
}

/* The command that writes such a file. */
static const char *command_of(const part *p) {
    return p->form.sites ? "graze contact" : result_command(p->form.kind);
}

static int complain_of_row(const part *p) {
    return complain(EXIT_INPUT, "%s: has other rows than the %lu it counts", p->in.name, p->rows);
}

/* The expected form, where graze classify has not written the row, else NULL. */
static const char *wrong(row_parts *parts, const part *p, field row) {
    const char *expected = memchr(row.start, '\0', row.length)
                               ? "no byte 0"
                               : row_check(parts, &p->form, p->in.context, row);
    if (expected)
        return expected;
    expected = row_point_is_written(parts->point, &p->form, p->in.context);
    if (expected)
        return expected;
    if (p->form.others && fields_count(parts->rest) != p->form.others)
        return "as many further columns as the column line has";
    return NULL;
}

static int refuse_row(const part *p, const char *expected) {
    return complain(EXIT_INPUT, "%s:%lu: is no row that %s writes; expected %s", p->in.name,
                    p->in.line, command_of(p), expected);
}

static void copy_line(output *out, field line) {
    output_bytes(out, line.start, line.length + 1); /* its line end stands behind it */
}

/* The intervals and contacts of a certificate's row. */
static int copy_intervals(part *p, output *out) {
    int status = EXIT_DONE;
    while (!status && !p->intervals.ended) {
        field line;
        status = next_line(p, &line);
        if (status)
            break;
        if (!line.start || !p->in.whole)
            return complain_of_row(p);
        const char *expected = certified_line(&p->intervals, &p->form, line);
        if (expected)
            return refuse_row(p, expected);
        copy_line(out, line);
    }
    return status;
}

int part_copy_row(part *p, output *out) {
    field line;
    row_parts parts;
    int status = next_line(p, &line);
    if (status)
        return status;
    if (!line.start || !p->in.whole || line_part_of(p->form.kind, line) == LINE_NOTE)
        return complain_of_row(p);
    const char *expected = wrong(&parts, p, line);
    if (expected)
        return refuse_row(p, expected);
    p->undecided += (unsigned long)row_is_undecided(line);
    copy_line(out, line);
    if (p->form.kind == RESULT_TABLE)
        return EXIT_DONE;
    if (!certified_begin(&p->intervals, parts.word))
        return complain(EXIT_IO, "out of memory");
    return copy_intervals(p, out);
}

int part_has_topo(const part *p) {
    return p->form.topo;
}

int part_end(part *p) {
    field line;
    int status = next_line(p, &line);
    if (status)
        return status;
    return line_part_of(p->form.kind, line) == LINE_NOTE ? EXIT_DONE : complain_of_row(p);
}

/* Take one line of the head; the one that names the shard is left out. */
static int take_head(part *p, field line, int *named) {
    field name;
    if (!*named && line_note(&name, p->form.kind, line, SHARD_LINE)) {
        char text[32] = "";
        memcpy(text, name.start, name.length < sizeof text ? name.length : sizeof text - 1);
        *named = shard_read(&p->shard, text);
        return EXIT_DONE;
    }
    stream_copy_line(&p->head, &p->in, line);
    return p->head.failed ? complain(EXIT_IO, "out of memory") : EXIT_DONE;
}

/* The first line says what the file is. */
static int find_kind(part *p, field line) {
    field version;
    p->form.kind = field_is(line, "graze-certificate 1") ? RESULT_CERTIFICATE : RESULT_TABLE;
    if (p->form.kind == RESULT_TABLE && !field_behind(&version, line, "# graze "))
        return complain(
            EXIT_INPUT,
            "%s: expected a table of graze classify or contact, or a certificate of graze certify",
            p->in.name);
    return EXIT_DONE;
}

static int read_head_lines(part *p, int *named) {
    int status = EXIT_DONE, ended = 0;
    while (!status && !ended) {
        field line;
        status = next_line(p, &line);
        if (status || !line.start)
            break;
        if (p->in.line == 1)
            status = find_kind(p, line);
        if (status)
            break;
        if (memchr(line.start, '\0', line.length))
            return complain(EXIT_INPUT, "%s:%lu: a byte 0 in a text file", p->in.name, p->in.line);
        ended = p->in.whole && line_ends_head(p->form.kind, line);
        status = take_head(p, line, named);
    }
    return status;
}

static int read_head(part *p) {
    int named = 0, status = read_head_lines(p, &named);
    result_kind kind = p->form.kind;
    if (status)
        return status;
    if (p->in.line == 0)
        return find_kind(p, (field){"", 0});
    if (!named)
        return complain(EXIT_INPUT,
                        "%s: has no line `%s" SHARD_LINE "i/n` in its head; expected a %s of %s "
                        "--shard i/n",
                        p->in.name, result_mark(kind), result_name(kind), command_of(p));
    if (row_form_read(&p->form, kind, p->head.data ? p->head.data : ""))
        return EXIT_DONE;
    if (kind == RESULT_TABLE)
        return complain(EXIT_INPUT,
                        "%s:%lu: is not the column line of graze classify: expected coordinates "
                        "and answers, and then the further columns",
                        p->in.name, p->in.line);
    return complain(EXIT_INPUT,
                    "%s: its head has no line `dimension` or `signs`, as graze certify "
                    "writes them",
                    p->in.name);
}

/* Take the value of last line `index`; 0 if it is no count. */
static int take_last_line(part *p, int index, field value) {
    size_t n = value.length;
    if (index != 1)
        return field_count(index ? &p->rows : &p->rows_of_all, value, ~0ul);
    memcpy(p->checksum, value.start, n < sizeof p->checksum ? n : sizeof p->checksum - 1);
    return 1;
}

/* Read the last lines, of which there must be these three. *found counts them, and is -1 where
 * another stands among them. */
static int read_last_lines(part *p, int *found) {
    static const char *const key[3] = {SHARD_ROWS, SHARD_POINTS, COMPLETE_LINE};
    field line, value;
    int status = next_line(p, &line); /* perhaps a piece of one */
    *found = 0;
    while (!status && line.start && *found >= 0) {
        status = next_line(p, &line);
        if (status || !line.start)
            break;
        if (*found < 3 && p->in.whole && line_note(&value, p->form.kind, line, key[*found]) &&
            take_last_line(p, *found, value))
            ++*found;
        else if (*found || memchr(line.start, '\0', line.length))
            *found = -1;
    }
    return status;
}

/* Read the last lines of a file of `size` bytes, and go back to the rows. */
static int read_tail(part *p, long long size) {
    long long rows = stream_tell(&p->in);
    unsigned long head_lines = p->in.line;
    int found = 0;
    int status = complain_of(stream_seek(&p->in, size > TAIL ? size - TAIL : 0), p->in.context);
    if (!status)
        status = read_last_lines(p, &found);
    if (status)
        return status;
    if (found != 3)
        return complain(EXIT_INPUT,
                        "%s: does not end with `%scomplete`: the run was interrupted; %s --resume "
                        "continues it",
                        p->in.name, result_mark(p->form.kind), command_of(p));
    unsigned long dealt = shard_rows(p->shard, p->rows_of_all);
    if (p->rows != dealt)
        return complain(EXIT_INPUT, "%s: counts %lu rows; expected %lu of %lu in all", p->in.name,
                        p->rows, dealt, p->rows_of_all);
    p->in.line = head_lines;
    return complain_of(stream_seek(&p->in, rows), p->in.context);
}

int part_open(part *p, graze_context *context, const char *path) {
    struct stat about;
    memset(p, 0, sizeof *p);
    p->in.fd = -1;
    if (stat(path, &about) != 0)
        return complain(EXIT_IO, "%s: cannot be opened: %s", path, strerror(errno));
    if (!S_ISREG(about.st_mode))
        return complain(EXIT_IO,
                        "%s: expected a plain file; parts are read in turn, which a pipe "
                        "does not allow",
                        path);
    int status = complain_of(stream_open_own(&p->in, context, path, 1), context);
    if (!status)
        status = read_head(p);
    return status ? status : read_tail(p, (long long)about.st_size);
}

void part_close(part *p) {
    stream_close(&p->in);
    certified_clear(&p->intervals);
    text_clear(&p->head);
}
