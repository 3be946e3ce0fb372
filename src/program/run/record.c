/* Keeps the record of an unfinished run. SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/run/results.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char first_words[] = "graze kept 1 ";
enum { LINE_MOST = 256 };

/* Write the line of a record, without the line's own checksum. */
static int put_record(char line[LINE_MOST], const record *r) {
    const struct recorded *table = &r->file[RESULT_TABLE],
                          *certificate = &r->file[RESULT_CERTIFICATE];
    return snprintf(line, LINE_MOST,
                    "%srows %020lu undecided %020lu wide %020lu points %016llx table %020llu "
                    "%016llx certificate %020llu %016llx",
                    first_words, r->rows, r->undecided, r->wide, r->points, table->length,
                    table->sum, certificate->length, certificate->sum);
}

static unsigned long long sum_of(const char *line, int length) {
    checksum c = {0, 0, 0};
    checksum_add(&c, line, (size_t)length);
    return checksum_value(&c);
}

/* Read the first bytes of the file; -1 if it cannot be read. */
static ssize_t read_beginning(char text[LINE_MOST], const char *path) {
    int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    ssize_t n = fd < 0 ? -1 : read(fd, text, LINE_MOST - 1);
    if (fd >= 0)
        close(fd);
    text[n > 0 ? n : 0] = '\0';
    return n;
}

int record_open(record_file *f, const char *path) {
    char text[LINE_MOST];
    f->fd = -1;
    f->written = clock_seconds();
    f->path = malloc(strlen(path) + sizeof RECORD_ENDING);
    if (!f->path)
        return complain(EXIT_IO, "out of memory");
    strcat(strcpy(f->path, path), RECORD_ENDING);
    ssize_t n = read_beginning(text, f->path);
    if ((n < 0 && errno == ENOENT) || n == 0 ||
        strncmp(text, first_words, strlen(first_words)) == 0)
        return EXIT_DONE;
    return complain(EXIT_INPUT,
                    "%s: is no record of graze, which would take its place; expected no file of "
                    "that name",
                    f->path);
}

int record_read(record *out, const record_file *f) {
    char text[LINE_MOST], same[LINE_MOST];
    struct recorded *table = &out->file[RESULT_TABLE],
                    *certificate = &out->file[RESULT_CERTIFICATE];
    unsigned long long sum;
    memset(out, 0, sizeof *out);
    if (!f->path || read_beginning(text, f->path) <= 0)
        return 0;
    const char *values = text + strlen(first_words);
    if (sscanf(values,
               "rows %lu undecided %lu wide %lu points %llx table %llu %llx certificate %llu %llx "
               "sum %llx",
               &out->rows, &out->undecided, &out->wide, &out->points, &table->length, &table->sum,
               &certificate->length, &certificate->sum, &sum) != 9)
        return 0;
    int length = put_record(same, out);
    return strncmp(text, same, (size_t)length) == 0 && sum == sum_of(same, length);
}

void record_write(record_file *f, const record *r, int now) {
    char line[LINE_MOST];
    double time = clock_seconds();
    if (!f->path || (!now && time - f->written < 1))
        return;
    if (f->fd < 0)
        f->fd = open(f->path, O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    f->written = time;
    int length = put_record(line, r);
    length +=
        snprintf(line + length, LINE_MOST - (size_t)length, " sum %016llx\n", sum_of(line, length));
    ssize_t ignored = f->fd < 0 ? 0 : pwrite(f->fd, line, (size_t)length, 0);
    (void)ignored;
}

void record_remove(record_file *f) {
    if (f->path)
        unlink(f->path);
}

void record_close(record_file *f) {
    if (f->fd >= 0 && f->path)
        close(f->fd);
    free(f->path);
    f->path = NULL;
}
