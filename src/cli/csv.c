/* Reads points from CSV in blocks (formats: Points).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The first line that is neither blank nor a comment fixes the columns. It is a header if it has a
 * field x, y or (in E^3) z. Further columns are handed on as the bytes they were. Only one buffer's
 * worth of the file is in memory.
 */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "cli/interrupt.h"
#include "cli/rows.h"

typedef struct field {
    const char *start;
    size_t length;
} field;

struct csv {
    int fd, dimension, ended;
    const char *name;
    graze_context *context;
    char *buffer;
    size_t capacity, from, to; /* bytes from..to are read and not yet used */
    unsigned long line;
    field *fields; /* of the line at hand */
    size_t field_count, field_capacity;
    size_t columns;  /* 0 until the first row is seen */
    size_t where[3]; /* the columns of x, y, z */
    char *others;    /* names of the further columns */
};

int csv_open(csv **out, const char *path, int dimension, graze_context *context) {
    int standard = strcmp(path, "-") == 0;
    struct stat about;
    csv *c = calloc(1, sizeof *c);
    *out = c;
    if (!c)
        return complain(EXIT_IO, "out of memory");
    c->name = standard ? "standard input" : path;
    c->dimension = dimension;
    c->context = context;
    c->capacity = 1 << 16;
    c->buffer = malloc(c->capacity);
    c->fd = standard ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC);
    if (c->fd < 0)
        return complain(EXIT_IO, "%s: cannot be opened: %s", c->name, strerror(errno));
    if (!c->buffer)
        return complain(EXIT_IO, "out of memory");
    if (fstat(c->fd, &about) == 0 && S_ISDIR(about.st_mode))
        return complain(EXIT_IO, "%s: is a directory; right is a CSV file", c->name);
    return EXIT_DONE;
}

void csv_close(csv *c) {
    if (!c)
        return;
    if (c->fd > STDIN_FILENO)
        close(c->fd);
    free(c->buffer);
    free(c->fields);
    free(c->others);
    free(c);
}

int csv_started(const csv *c) {
    return c->columns > 0;
}

const char *csv_columns(const csv *c) {
    return c->others;
}

int csv_same_file(const csv *c, const char *path) {
    struct stat mine, other;
    return fstat(c->fd, &mine) == 0 && stat(path, &other) == 0 && S_ISREG(mine.st_mode) &&
           mine.st_dev == other.st_dev && mine.st_ino == other.st_ino;
}

static int check_length(const csv *c, size_t length, unsigned long line) {
    unsigned long limit = graze_context_limit(c->context, GRAZE_LIMIT_LINE);
    if (length <= limit)
        return EXIT_DONE;
    return complain(EXIT_LIMIT,
                    "%s:%lu: the line has more than %lu bytes; raise it with --limit line=V",
                    c->name, line, limit);
}

/* Make room behind the unused bytes, which are part of one line. */
static int make_room(csv *c) {
    memmove(c->buffer, c->buffer + c->from, c->to - c->from);
    c->to -= c->from;
    c->from = 0;
    int status = check_length(c, c->to, c->line + 1);
    if (status || c->to < c->capacity)
        return status;
    char *grown = realloc(c->buffer, 2 * c->capacity);
    if (!grown)
        return complain(EXIT_IO, "out of memory");
    c->buffer = grown;
    c->capacity *= 2;
    return EXIT_DONE;
}

static int read_more(csv *c) {
    int status = make_room(c);
    if (status)
        return status;
    for (;;) {
        interrupt_wait(c->fd);
        if (interrupt_signal())
            return EXIT_SIGNAL;
        ssize_t n = read(c->fd, c->buffer + c->to, c->capacity - c->to);
        if (n >= 0) {
            c->ended = n == 0;
            c->to += (size_t)n;
            return EXIT_DONE;
        }
        if (errno != EINTR && errno != EAGAIN)
            return complain(EXIT_IO, "%s: reading failed: %s", c->name, strerror(errno));
    }
}

/* The next line without its end. A length of 0 and no start mean the end of the file. */
static int next_line(csv *c, field *out) {
    size_t seen = 0;
    char *end = NULL;
    *out = (field){NULL, 0};
    while (!end && !c->ended) {
        end = memchr(c->buffer + c->from + seen, '\n', c->to - c->from - seen);
        seen = c->to - c->from;
        if (!end) {
            int status = read_more(c);
            if (status)
                return status;
        }
    }
    if (!end && c->from == c->to)
        return EXIT_DONE;
    out->start = c->buffer + c->from;
    out->length = end ? (size_t)(end - out->start) : c->to - c->from;
    c->from += out->length + (end != NULL);
    c->line++;
    if (out->length && out->start[out->length - 1] == '\r')
        out->length--;
    if (c->line == 1 && out->length >= 3 && memcmp(out->start, "\xef\xbb\xbf", 3) == 0) {
        out->start += 3;
        out->length -= 3;
    }
    return check_length(c, out->length, c->line);
}

static int is_blank(char byte) {
    return byte == ' ' || byte == '\t';
}

static field trimmed(field f) {
    for (; f.length && is_blank(*f.start); f.start++)
        f.length--;
    while (f.length && is_blank(f.start[f.length - 1]))
        f.length--;
    return f;
}

/* What a field says: without blanks around it and the quotes around what is left. */
static field content(field f) {
    f = trimmed(f);
    if (f.length >= 2 && *f.start == '"') {
        f.start++;
        f.length -= 2;
    }
    return f;
}

static int add_field(csv *c, field f) {
    if (c->field_count == c->field_capacity) {
        size_t capacity = 2 * c->field_capacity + 16;
        field *grown = realloc(c->fields, capacity * sizeof *grown);
        if (!grown)
            return complain(EXIT_IO, "out of memory");
        c->fields = grown;
        c->field_capacity = capacity;
    }
    c->fields[c->field_count++] = f;
    return EXIT_DONE;
}

/* Where a field that begins at `at` ends; NULL if a quote in it is not closed or followed by more.
 */
static const char *field_end(const char *at, const char *end) {
    while (at < end && is_blank(*at))
        at++;
    if (at == end || *at != '"') {
        while (at < end && *at != ',')
            at++;
        return at;
    }
    for (at++; at < end; at++) {
        if (*at != '"')
            continue;
        if (at + 1 == end || at[1] != '"')
            break;
        at++;
    }
    if (at == end)
        return NULL;
    for (at++; at < end && is_blank(*at);)
        at++;
    return at == end || *at == ',' ? at : NULL;
}

static int split(csv *c, field line) {
    const char *at = line.start, *end = at + line.length;
    c->field_count = 0;
    for (;;) {
        const char *stop = field_end(at, end);
        if (!stop)
            return complain(EXIT_INPUT,
                            "%s:%lu: a quoted field must end on its line, before a "
                            "comma or the line's end",
                            c->name, c->line);
        int status = add_field(c, (field){at, (size_t)(stop - at)});
        if (status || stop == end)
            return status;
        at = stop + 1;
    }
}

/* 0, 1, 2 for x, y, z; -1 for any other name. */
static int axis_of(field f, int dimension) {
    f = content(f);
    if (f.length != 1 || *f.start < 'x' || *f.start >= 'x' + dimension)
        return -1;
    return *f.start - 'x';
}

static int is_coordinate(const csv *c, size_t column) {
    for (int k = 0; k < c->dimension; k++)
        if (c->where[k] == column)
            return 1;
    return 0;
}

/* The fields that are no coordinates, or their names where there is no header, comma-joined. */
static int join_others(char **out, const csv *c, int numbered) {
    size_t room = 1;
    *out = NULL;
    if (c->field_count <= (size_t)c->dimension)
        return EXIT_DONE;
    for (size_t k = 0; k < c->field_count; k++)
        room += (numbered ? 28 : c->fields[k].length) + 1;
    char *text = malloc(room), *at = text;
    int first = 1;
    if (!text)
        return complain(EXIT_IO, "out of memory");
    for (size_t k = 0; k < c->field_count; k++) {
        if (is_coordinate(c, k))
            continue;
        if (!first)
            *at++ = ',';
        first = 0;
        if (numbered) {
            at += sprintf(at, "column%zu", k + 1);
        } else {
            memcpy(at, c->fields[k].start, c->fields[k].length);
            at += c->fields[k].length;
        }
    }
    *at = '\0';
    *out = text;
    return EXIT_DONE;
}

/* Fix the columns by the first line; *header says whether it names them. */
static int fix_columns(csv *c, int *header) {
    int found[3] = {0, 0, 0}, any = 0;
    for (int k = 0; k < 3; k++)
        c->where[k] = (size_t)k;
    for (size_t k = 0; k < c->field_count; k++) {
        int axis = axis_of(c->fields[k], c->dimension);
        if (axis < 0)
            continue;
        if (found[axis]++)
            return complain(EXIT_INPUT, "%s:%lu: the header names %c twice", c->name, c->line,
                            'x' + axis);
        c->where[axis] = k;
        any = 1;
    }
    for (int k = 0; any && k < c->dimension; k++)
        if (!found[k])
            return complain(EXIT_INPUT, "%s:%lu: the header names no column %c", c->name, c->line,
                            'x' + k);
    if (c->field_count < (size_t)c->dimension)
        return complain(EXIT_INPUT,
                        "%s:%lu: %zu columns; right are at least %d, or a header "
                        "naming x, y%s",
                        c->name, c->line, c->field_count, c->dimension,
                        c->dimension == 3 ? ", z" : "");
    c->columns = c->field_count;
    *header = any;
    return join_others(&c->others, c, !any);
}

static int read_row(csv *c, row *out) {
    for (int k = 0; k < c->dimension; k++) {
        field f = content(c->fields[c->where[k]]);
        graze_status status = graze_number_parse(out->point[k], c->context, f.start, f.length);
        if (status)
            return complain(status == GRAZE_ELIMIT ? EXIT_LIMIT : EXIT_INPUT, "%s:%lu: %c: %s",
                            c->name, c->line, 'x' + k, graze_context_message(c->context));
    }
    return join_others(&out->rest, c, 0);
}

static int skipped(field line) {
    return (line.length && *line.start == '#') || trimmed(line).length == 0;
}

/* One line into the block. */
static int take_line(csv *c, block *b, field line) {
    int header = 0;
    if (memchr(line.start, '\0', line.length))
        return complain(EXIT_INPUT, "%s:%lu: a byte 0 in a text file", c->name, c->line);
    int status = split(c, line);
    if (!status && !c->columns)
        status = fix_columns(c, &header);
    if (status || header)
        return status;
    if (c->field_count != c->columns)
        return complain(EXIT_INPUT, "%s:%lu: %zu columns; right are %zu, as on the first line",
                        c->name, c->line, c->field_count, c->columns);
    status = read_row(c, &b->rows[b->count]);
    b->count += status == EXIT_DONE;
    return status;
}

/* A block is also done when a pipe has no further line ready, so that its reader is not kept
 * waiting. */
static int line_ready(const csv *c) {
    return memchr(c->buffer + c->from, '\n', c->to - c->from) != NULL;
}

int csv_fill(csv *c, block *b) {
    int status = EXIT_DONE;
    while (!status && b->count < BLOCK_ROWS && (b->count == 0 || c->ended || line_ready(c))) {
        field line;
        status = next_line(c, &line);
        if (!status && !line.start)
            break;
        if (!status && !skipped(line))
            status = take_line(c, b, line);
    }
    return status;
}
