/* Reads a part of a table or a certificate (run.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/run/run.h"

#include <errno.h>
#include <sys/stat.h>
#include "base/context/scope.h"

/* The last lines are within this number of bytes of the end. */
enum { TAIL = 512 };

static int next_line(part *p, field *line) {
    return complain_of(stream_next(&p->in, line), p->in.context);
}

/* The command that writes files such as this part. */
static const char *command_of(const part *p) {
    int sites = p->head.data && strstr(p->head.data, "\ntime,");
    return sites ? "graze contact" : p->kind == RESULT_TABLE ? "graze classify" : "graze certify";
}

static int complain_of_rows(const part *p) {
    return complain(EXIT_INPUT, "%s: has other rows than the %lu it counts", p->in.name,
                    p->last.rows);
}

/* Read the next line. The caller has already added the line before it to the checksum. */
static int go_on(part *p) {
    int status = next_line(p, &p->next);
    return !status && p->next.start && !p->in.whole ? complain_of_rows(p) : status;
}

static void sum_line(part *p, field line) {
    checksum_add(&p->sum, line.start, line.length);
    checksum_add(&p->sum, "\n", 1);
}

/* Copy the line `next` with its line end, which is the byte behind it. */
static int copy_line(part *p, output *out) {
    sum_line(p, p->next);
    output_bytes(out, p->next.start, p->next.length + 1);
    return go_on(p);
}

int part_copy_row(part *p, output *out) {
    if (!p->next.start)
        TRY(go_on(p));
    if (!p->next.start || line_part_of(p->kind, p->next) != LINE_ROW)
        return complain_of_rows(p);
    do {
        TRY(copy_line(p, out));
    } while (p->next.start && line_part_of(p->kind, p->next) == LINE_OF_ROW);
    return EXIT_DONE;
}

int part_end(part *p) {
    field value;
    if (!p->next.start)
        TRY(go_on(p));
    if (p->next.start && line_part_of(p->kind, p->next) != LINE_NOTE)
        return complain_of_rows(p);
    while (p->next.start && !line_note(&value, p->kind, p->next, SHARD_BYTES)) {
        sum_line(p, p->next);
        TRY(go_on(p));
    }
    if (checksum_value(&p->sum) == p->last.bytes)
        return EXIT_DONE;
    return complain(EXIT_INPUT,
                    "%s: was changed: its bytes have another checksum than its last lines say; "
                    "expected a %s as %s wrote it",
                    p->in.name, result_name(p->kind), command_of(p));
}

/* Take one line of the head; the line that names the shard is not kept in it. */
static int take_head(part *p, field line, int *named) {
    field name;
    checksum_add(&p->sum, line.start, line.length);
    checksum_add(&p->sum, "\n", p->in.whole);
    if (!*named && line_note(&name, p->kind, line, SHARD_LINE)) {
        char text[32] = "";
        memcpy(text, name.start, name.length < sizeof text ? name.length : sizeof text - 1);
        *named = shard_read(&p->shard, text);
        return EXIT_DONE;
    }
    stream_copy_line(&p->head, &p->in, line);
    return p->head.failed ? complain(EXIT_IO, "out of memory") : EXIT_DONE;
}

/* Find the kind of a part from its first line. */
static int find_kind(part *p, field line) {
    field version;
    p->kind = field_is(line, "graze-certificate 1") ? RESULT_CERTIFICATE : RESULT_TABLE;
    if (p->kind == RESULT_TABLE && !field_behind(&version, line, "# graze "))
        return complain(
            EXIT_INPUT,
            "%s: expected a table of graze classify or contact, or a certificate of graze certify",
            p->in.name);
    return EXIT_DONE;
}

static int read_head_lines(part *p, int *named) {
    for (int ended = 0; !ended;) {
        field line;
        TRY(next_line(p, &line));
        if (!line.start)
            break;
        if (p->in.line == 1)
            TRY(find_kind(p, line));
        if (memchr(line.start, '\0', line.length))
            return complain(EXIT_INPUT, "%s:%lu: a byte 0 in a text file", p->in.name, p->in.line);
        ended = p->in.whole && line_ends_head(p->kind, line);
        TRY(take_head(p, line, named));
    }
    return EXIT_DONE;
}

static int read_head(part *p) {
    int named = 0;
    TRY(read_head_lines(p, &named));
    if (p->in.line == 0)
        return find_kind(p, (field){"", 0});
    if (!named)
        return complain(EXIT_INPUT,
                        "%s: has no line `%s" SHARD_LINE "i/n` in its head; expected a %s of %s "
                        "--shard i/n",
                        p->in.name, result_mark(p->kind), result_name(p->kind), command_of(p));
    return EXIT_DONE;
}

/* Read the whole lines at the end of the file. */
static int read_tail_lines(part *p, text *tail) {
    field line;
    TRY(next_line(p, &line)); /* the first line may lack its beginning, so it is left out */
    while (line.start) {
        TRY(next_line(p, &line));
        if (line.start)
            stream_copy_line(tail, &p->in, line);
    }
    return tail->failed ? complain(EXIT_IO, "out of memory") : EXIT_DONE;
}

/* Read the last lines of a file of `size` bytes, and go back to the rows. */
static int read_tail(part *p, long long size) {
    long long rows = stream_tell(&p->in);
    unsigned long head_lines = p->in.line;
    HELD(text, tail);
    TRY(complain_of(stream_seek(&p->in, size > TAIL ? size - TAIL : 0), p->in.context));
    TRY(read_tail_lines(p, &tail));
    int found = tail.length ? last_lines_read(&p->last, p->kind, tail.data) : 0;
    if (found < 0)
        return complain(EXIT_IO, "out of memory");
    if (!found)
        return complain(EXIT_INPUT,
                        "%s: does not end with `%sbytes-checksum` and `complete`: the run was "
                        "interrupted, or an older graze made it; %s --resume continues it",
                        p->in.name, result_mark(p->kind), command_of(p));
    unsigned long dealt = shard_rows(p->shard, p->last.rows_of_all);
    if (p->last.rows != dealt)
        return complain(EXIT_INPUT, "%s: counts %lu rows; expected %lu of %lu in all", p->in.name,
                        p->last.rows, dealt, p->last.rows_of_all);
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
    TRY(complain_of(stream_open_own(&p->in, context, path, 1), context));
    TRY(read_head(p));
    return read_tail(p, (long long)about.st_size);
}

void part_close(part *p) {
    stream_close(&p->in);
    text_clear(&p->head);
}
