/* Reads points from CSV in blocks (src/cli/formats.md, Points).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Lines are found and handed on as they are (columns.h reads them); those of other shards are only
 * counted. One buffer's worth of the file and one block are in memory.
 */
#include "run/csv.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "run/interrupt.h"
#include "run/source.h"

struct csv {
    int fd, ended;
    graze_context *context;
    char *buffer;
    size_t capacity, from, to; /* bytes from..to are read and not yet used */
    unsigned long line;
    int status; /* of the last read */
    fault fault;
    columns columns;
    shard part;
    unsigned long rows; /* of all shards, so far */
    unsigned long long checksum;
    portion portion; /* in bytes; `whole` is 0 unless it is a file */
};

int csv_open(csv **out, const char *path, int dimension, shard part, graze_context *context) {
    int standard = strcmp(path, "-") == 0;
    struct stat about;
    csv *c = calloc(1, sizeof *c);
    *out = c;
    if (!c)
        return complain(EXIT_IO, "out of memory");
    c->columns = (columns){standard ? "standard input" : path, dimension, 0, {0, 0, 0}, NULL};
    c->part = part;
    c->context = context;
    c->capacity = 1 << 16;
    c->buffer = malloc(c->capacity);
    int status = standard ? source_standard(&c->fd) : source_open(&c->fd, path);
    if (status)
        return status;
    if (!c->buffer)
        return complain(EXIT_IO, "out of memory");
    if (fstat(c->fd, &about) == 0 && S_ISREG(about.st_mode) && about.st_size > 0)
        c->portion.whole = (unsigned long)about.st_size;
    return EXIT_DONE;
}

void csv_close(csv *c) {
    if (!c)
        return;
    if (c->fd > STDIN_FILENO)
        close(c->fd);
    free(c->buffer);
    fault_clear(&c->fault);
    columns_clear(&c->columns);
    free(c);
}

const fault *csv_fault(const csv *c) {
    return &c->fault;
}

const columns *csv_columns(const csv *c) {
    return &c->columns;
}

portion csv_portion(const csv *c) {
    return c->portion;
}

unsigned long csv_rows(const csv *c) {
    return c->rows;
}

unsigned long long csv_checksum(const csv *c) {
    return c->checksum;
}

int csv_same_file(const csv *c, const char *path) {
    struct stat mine, other;
    return fstat(c->fd, &mine) == 0 && stat(path, &other) == 0 && S_ISREG(mine.st_mode) &&
           mine.st_dev == other.st_dev && mine.st_ino == other.st_ino;
}

static int check_point_line(csv *c, size_t length, unsigned long line) {
    unsigned long limit = graze_context_limit(c->context, GRAZE_LIMIT_LINE);
    if (length <= limit)
        return EXIT_DONE;
    return fault_set(&c->fault, EXIT_LIMIT,
                     "%s:%lu: the line has more than %lu bytes; raise it with --limit line=V",
                     c->columns.name, line, limit);
}

/* Make room behind the unused bytes, which are part of one line. */
static int make_row_room(csv *c) {
    memmove(c->buffer, c->buffer + c->from, c->to - c->from);
    c->to -= c->from;
    c->from = 0;
    int status = check_point_line(c, c->to, c->line + 1);
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
    c->status = make_row_room(c);
    if (c->status)
        return;
    ssize_t n = read(c->fd, c->buffer + c->to, c->capacity - c->to);
    if (n >= 0) {
        c->ended = n == 0;
        c->to += (size_t)n;
        c->portion.done += (size_t)n;
    } else if (errno != EINTR && errno != EAGAIN) {
        c->status = fault_set(&c->fault, EXIT_IO, "%s: reading failed: %s", c->columns.name,
                              strerror(errno));
    }
}

/* The next line without its end. A length of 0 and no start mean the end of the file. */
static int next_point_line(csv *c, field *out) {
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
    return check_point_line(c, out->length, c->line);
}

static int skipped(field text) {
    return (text.length && *text.start == '#') || field_trimmed(text).length == 0;
}

/* 64 bits that tell one sequence of lines from another, as far as accidents go: 8 bytes at a time,
 * the first one lowest, the line's length last. */
static unsigned long long add_to_checksum(unsigned long long sum, field text) {
    const unsigned char *at = (const unsigned char *)text.start;
    for (size_t left = text.length; left; left -= left < 8 ? left : 8, at += 8) {
        unsigned long long word = 0;
        for (size_t k = 0; k < 8 && k < left; k++)
            word |= (unsigned long long)at[k] << 8 * k;
        sum = (sum ^ word) * 0x9e3779b97f4a7c15ULL;
        sum ^= sum >> 32;
    }
    return (sum ^ text.length) * 0x9e3779b97f4a7c15ULL;
}

/* A row into the block, if it is the shard's. */
static int take_row(csv *c, block *b, field text) {
    unsigned long row = c->rows++;
    if (c->part.count > 1)
        c->checksum = add_to_checksum(c->checksum, text);
    if (row % c->part.count != c->part.index)
        return EXIT_DONE;
    return block_add(b, text, c->line) ? EXIT_DONE : fault_set(&c->fault, EXIT_IO, "out of memory");
}

/* A line that is neither blank nor a comment; the first one fixes the columns. */
static int take_point_line(csv *c, block *b, field text) {
    int header = 0, status = EXIT_DONE;
    if (!c->columns.count)
        status = columns_fix(&header, &c->fault, &c->columns, text, c->line);
    return status || header ? status : take_row(c, b, text);
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
int csv_fill(csv *c, block *b, unsigned long most) {
    int status = EXIT_DONE;
    while (!status && b->count < BLOCK_ROWS && b->count < most && b->used < BLOCK_BYTES &&
           (b->count == 0 || csv_ready(c))) {
        field text;
        status = next_point_line(c, &text);
        if (!status && !text.start)
            break;
        if (!status && !skipped(text))
            status = take_point_line(c, b, text);
    }
    return status;
}
