/* Reads points from .npy files, some rows at a time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A row becomes a line of text with the same values, so that rows of all files are read in the same
 * way.
 */
#include "program/points/heads.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Read bytes of the file; 0 on an error, or if the file ends before. */
static int read_bytes(int fd, void *to, size_t length, size_t from, size_t *got) {
    *got = 0;
    while (*got < length) {
        ssize_t n = pread(fd, (char *)to + *got, length - *got, (off_t)(from + *got));
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return n == 0;
        *got += (size_t)n;
    }
    return 1;
}

int npy_is(int fd, const char *name) {
    struct stat about;
    char first[8];
    size_t got, length = strlen(name);
    if (fd <= STDIN_FILENO || fstat(fd, &about) != 0 || !S_ISREG(about.st_mode))
        return 0;
    if (length > 4 && strcmp(name + length - 4, ".npy") == 0)
        return 1;
    return read_bytes(fd, first, sizeof first, 0, &got) && npy_is_begun(first, got);
}

static int unreadable(fault *f, const npy *a) {
    return fault_set(f, EXIT_IO, "%s: cannot be read: %s", a->name, strerror(errno));
}

static int read_array_head(npy *a, fault *f) {
    struct stat about;
    size_t got;
    char *bytes = (char *)a->bytes;
    if (fstat(a->fd, &about) != 0 || !read_bytes(a->fd, bytes, NPY_HEAD_MOST, 0, &got))
        return unreadable(f, a);
    int status = npy_head_read(&a->head, f, a->name, bytes, got, a->dimension);
    if (status)
        return status;
    unsigned long row = (unsigned long)(a->head.size * a->dimension);
    unsigned long there = (unsigned long)about.st_size - a->head.start;
    if (there / row == a->head.rows && there % row == 0)
        return EXIT_DONE;
    return fault_set(f, EXIT_INPUT, "%s: %lu bytes behind its head; expected %lu rows of %lu bytes",
                     a->name, there, a->head.rows, row);
}

int npy_open(npy **out, fault *f, graze_context *context, int fd, const char *name, int dimension) {
    npy *a = *out = malloc(sizeof *a);
    if (!a)
        return fault_set(f, EXIT_IO, "out of memory");
    a->fd = fd;
    a->name = name;
    a->context = context;
    a->dimension = dimension;
    a->done = a->from = a->to = 0;
    text_init(&a->line);
    mpq_init(a->value);
    return read_array_head(a, f);
}

void npy_close(npy *a) {
    if (!a)
        return;
    text_clear(&a->line);
    mpq_clear(a->value);
    free(a);
}

/* Read the next rows. */
static int read_rows(npy *a, fault *f) {
    const npy_head *h = &a->head;
    size_t size = (size_t)h->size, d = (size_t)a->dimension, parts = h->column_after_column ? d : 1;
    unsigned long left = h->rows - a->to;
    a->from = a->to;
    a->to += left < NPY_ROWS ? left : NPY_ROWS;
    size_t rows = a->to - a->from, length = rows * size * (h->column_after_column ? 1 : d);
    for (size_t part = 0; part < parts; part++) {
        size_t got, first = part * h->rows + a->from * (h->column_after_column ? 1 : d);
        if (!read_bytes(a->fd, a->bytes + part * length, length, h->start + first * size, &got))
            return unreadable(f, a);
        if (got < length)
            return fault_set(f, EXIT_IO, "%s: another program has changed it", a->name);
    }
    return EXIT_DONE;
}

/* The bits of a number in memory. */
static uint64_t bits_of(const npy *a, size_t row, size_t column) {
    size_t size = (size_t)a->head.size, d = (size_t)a->dimension;
    size_t at = a->head.column_after_column ? column * (a->to - a->from) + row : row * d + column;
    const unsigned char *bytes = a->bytes + at * size;
    uint64_t out = 0;
    for (size_t k = 0; k < size; k++)
        out |= (uint64_t)bytes[a->head.big_endian ? size - 1 - k : k] << 8 * k;
    return out;
}

static double float_of(uint64_t bits, int size) {
    uint32_t low = (uint32_t)bits;
    double wide;
    float narrow;
    memcpy(&wide, &bits, sizeof wide);
    memcpy(&narrow, &low, sizeof narrow);
    return size == 8 ? wide : (double)narrow;
}

/* Add a float as its exact decimal; `k` is the number of its column. */
static int put_float(npy *a, fault *f, double value, int k) {
    char *decimal = NULL;
    if (!isfinite(value))
        return fault_set(f, EXIT_INPUT, "%s: row %lu: %c: expected a finite number", a->name,
                         a->done + 1, 'x' + k);
    mpq_set_d(a->value, value);
    int status = fault_of(f, graze_number_decimal(&decimal, a->context, a->value, 0), a->context,
                          EXIT_FAULT);
    text_put(&a->line, status ? "" : decimal);
    graze_free(decimal);
    return status;
}

static int put_array_number(npy *a, fault *f, uint64_t bits, int k) {
    int unused = 64 - 8 * a->head.size;
    if (a->head.kind == 'f')
        return put_float(a, f, float_of(bits, a->head.size), k);
    if (a->head.kind == 'u' || !(bits >> (8 * a->head.size - 1)))
        text_format(&a->line, "%llu", (unsigned long long)bits);
    else /* two's complement: the value is -(2^64 - bits), bits filled up with ones */
        text_format(&a->line, "-%llu",
                    (unsigned long long)(0 - (bits | ~(~UINT64_C(0) >> unused))));
    return EXIT_DONE;
}

int npy_next(npy *a, fault *f, field *line) {
    int status = EXIT_DONE;
    *line = (field){NULL, 0};
    if (a->done == a->head.rows)
        return EXIT_DONE;
    if (a->done == a->to)
        status = read_rows(a, f);
    a->line.length = 0;
    for (int k = 0; k < a->dimension && !status; k++) {
        text_put(&a->line, k ? "," : "");
        status = put_array_number(a, f, bits_of(a, a->done - a->from, (size_t)k), k);
    }
    if (!status && a->line.failed)
        status = fault_set(f, EXIT_IO, "out of memory");
    a->done++;
    if (!status)
        *line = (field){a->line.data, a->line.length};
    return status;
}
