/* Reads points from CSV in blocks (formats: Points).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The first line that is neither blank nor a comment fixes the columns. It is a header if it has a
 * field x, y or (in E^3) z. Further columns are handed on as the bytes they were. Only one buffer's
 * worth of the file and one block are in memory.
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

struct csv {
    int fd, dimension, ended;
    const char *name;
    graze_context *context;
    char *buffer;
    size_t capacity, from, to; /* bytes from..to are read and not yet used */
    unsigned long line;
    int status; /* of the last read */
    fault fault;
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
    fault_clear(&c->fault);
    free(c->others);
    free(c);
}

const fault *csv_fault(const csv *c) {
    return &c->fault;
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

static int check_length(csv *c, size_t length, unsigned long line) {
    unsigned long limit = graze_context_limit(c->context, GRAZE_LIMIT_LINE);
    if (length <= limit)
        return EXIT_DONE;
    return fault_set(&c->fault, EXIT_LIMIT,
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
        return fault_set(&c->fault, EXIT_IO, "out of memory");
    c->buffer = grown;
    c->capacity *= 2;
    return EXIT_DONE;
}

static void read_once(csv *c) {
    c->status = make_room(c);
    if (c->status)
        return;
    ssize_t n = read(c->fd, c->buffer + c->to, c->capacity - c->to);
    if (n >= 0) {
        c->ended = n == 0;
        c->to += (size_t)n;
    } else if (errno != EINTR && errno != EAGAIN) {
        c->status =
            fault_set(&c->fault, EXIT_IO, "%s: reading failed: %s", c->name, strerror(errno));
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
        if (end)
            break;
        if (!c->status)
            interrupt_wait(c->fd);
        if (interrupt_signal())
            return EXIT_SIGNAL;
        if (!c->status)
            read_once(c);
        if (c->status)
            return c->status;
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

/* Cut a line into fields, or say what is wrong with it. */
static int cut(fields *out, fault *f, const csv *c, field text, unsigned long number) {
    if (memchr(text.start, '\0', text.length))
        return fault_set(f, EXIT_INPUT, "%s:%lu: a byte 0 in a text file", c->name, number);
    switch (fields_cut(out, text)) {
    case FIELDS_CUT:
        return EXIT_DONE;
    case FIELDS_OPEN_QUOTE:
        return fault_set(f, EXIT_INPUT,
                         "%s:%lu: a quoted field must end on its line, before a comma or the "
                         "line's end",
                         c->name, number);
    default:
        return fault_set(f, EXIT_IO, "out of memory");
    }
}

/* 0, 1, 2 for x, y, z; -1 for any other name. */
static int axis_of(field f, int dimension) {
    f = field_content(f);
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

/* Names for the fields that are no coordinates, comma-joined; numbers where there is no header. */
static int name_others(csv *c, const fields *first, int numbered) {
    size_t room = 1;
    if (first->count <= (size_t)c->dimension)
        return EXIT_DONE;
    for (size_t k = 0; k < first->count; k++)
        room += (numbered ? 28 : first->item[k].length) + 1;
    char *at = c->others = malloc(room);
    int some = 0;
    if (!at)
        return fault_set(&c->fault, EXIT_IO, "out of memory");
    for (size_t k = 0; k < first->count; k++) {
        if (is_coordinate(c, k))
            continue;
        if (some)
            *at++ = ',';
        some = 1;
        if (numbered) {
            at += sprintf(at, "column%zu", k + 1);
        } else {
            memcpy(at, first->item[k].start, first->item[k].length);
            at += first->item[k].length;
        }
    }
    *at = '\0';
    return EXIT_DONE;
}

/* Fix the columns by the first line; *header says whether it names them. */
static int fix_columns(int *header, csv *c, const fields *first) {
    int found[3] = {0, 0, 0};
    fault *f = &c->fault;
    *header = 0;
    for (int k = 0; k < 3; k++)
        c->where[k] = (size_t)k;
    for (size_t k = 0; k < first->count; k++) {
        int axis = axis_of(first->item[k], c->dimension);
        if (axis < 0)
            continue;
        if (found[axis]++)
            return fault_set(f, EXIT_INPUT, "%s:%lu: the header names %c twice", c->name, c->line,
                             'x' + axis);
        c->where[axis] = k;
        *header = 1;
    }
    for (int k = 0; *header && k < c->dimension; k++)
        if (!found[k])
            return fault_set(f, EXIT_INPUT, "%s:%lu: the header names no column %c", c->name,
                             c->line, 'x' + k);
    if (first->count < (size_t)c->dimension)
        return fault_set(
            f, EXIT_INPUT, "%s:%lu: %zu columns; right are at least %d, or a header naming x, y%s",
            c->name, c->line, first->count, c->dimension, c->dimension == 3 ? ", z" : "");
    c->columns = first->count;
    return name_others(c, first, !*header);
}

/* The first line fixes the columns; *header says whether it is no row. */
static int take_first(int *header, csv *c, field text) {
    fields first = {NULL, 0, 0};
    int status = cut(&first, &c->fault, c, text, c->line);
    if (!status)
        status = fix_columns(header, c, &first);
    fields_clear(&first);
    return status;
}

static int skipped(field text) {
    return (text.length && *text.start == '#') || field_trimmed(text).length == 0;
}

/* One line into the block. */
static int take_line(csv *c, block *b, field text) {
    int header = 0;
    int status = c->columns ? EXIT_DONE : take_first(&header, c, text);
    if (!status && !header && !block_add(b, text, c->line))
        status = fault_set(&c->fault, EXIT_IO, "out of memory");
    return status;
}

int csv_ready(csv *c) {
    while (!c->ended && !c->status && !memchr(c->buffer + c->from, '\n', c->to - c->from)) {
        if (!interrupt_ready(c->fd))
            return 0;
        read_once(c);
    }
    return 1;
}

/* A block is also done when no further line is ready, so that who reads its rows does not wait. */
int csv_fill(csv *c, block *b) {
    int status = EXIT_DONE;
    while (!status && b->count < BLOCK_ROWS && b->used < BLOCK_BYTES &&
           (b->count == 0 || csv_ready(c))) {
        field text;
        status = next_line(c, &text);
        if (!status && !text.start)
            break;
        if (!status && !skipped(text))
            status = take_line(c, b, text);
    }
    return status;
}

/* Add the fields that are no coordinates to `rest` as they were. They are shorter than the line. */
static int keep_others(reader *r, const csv *c, size_t length) {
    if (r->rest_capacity - r->rest_length <= length) {
        size_t capacity = 2 * (r->rest_length + length) + 64;
        char *grown = realloc(r->rest, capacity);
        if (!grown)
            return 0;
        r->rest = grown;
        r->rest_capacity = capacity;
    }
    char *at = r->rest + r->rest_length;
    int some = 0;
    for (size_t k = 0; k < r->cut.count; k++) {
        if (is_coordinate(c, k))
            continue;
        if (some)
            *at++ = ',';
        some = 1;
        memcpy(at, r->cut.item[k].start, r->cut.item[k].length);
        at += r->cut.item[k].length;
    }
    *at++ = '\0';
    r->rest_length = (size_t)(at - r->rest);
    return 1;
}

int csv_row(mpq_t *point, fault *f, const csv *c, reader *r, const block *b, size_t index) {
    const line *l = &b->lines[index];
    int status = cut(&r->cut, f, c, (field){b->bytes + l->start, l->length}, l->number);
    if (status)
        return status;
    if (r->cut.count != c->columns)
        return fault_set(f, EXIT_INPUT, "%s:%lu: %zu columns; right are %zu, as on the first line",
                         c->name, l->number, r->cut.count, c->columns);
    for (int k = 0; k < c->dimension; k++) {
        field token = field_content(r->cut.item[c->where[k]]);
        graze_status read = graze_number_parse(point[k], r->context, token.start, token.length);
        if (read)
            return fault_set(f, read == GRAZE_ELIMIT ? EXIT_LIMIT : EXIT_INPUT, "%s:%lu: %c: %s",
                             c->name, l->number, 'x' + k, graze_context_message(r->context));
    }
    return c->others && !keep_others(r, c, l->length) ? fault_set(f, EXIT_IO, "out of memory")
                                                      : EXIT_DONE;
}

void reader_clear(reader *r) {
    fields_clear(&r->cut);
    free(r->rest);
    *r = (reader){NULL, {NULL, 0, 0}, NULL, 0, 0};
}
