/* Reads a part of a table (part.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "run/part.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "run/status.h"
#include "run/numbers.h"

enum { BUFFER = 1 << 14, TAIL = 256 };

static int complain_of_system(const part *p, const char *what) {
    return complain(EXIT_IO, "%s: %s: %s", p->path, what, strerror(errno));
}

/* Fill the buffer, all of which is used, from the byte `at` on. */
static int refill(part *p) {
    FILE *file = fopen(p->path, "r");
    if (!file)
        return complain_of_system(p, "cannot be opened");
    setvbuf(file, NULL, _IONBF, 0);
    int failed = fseeko(file, (off_t)p->at, SEEK_SET) != 0;
    p->from = 0;
    p->to = failed ? 0 : fread(p->buffer, 1, BUFFER, file);
    failed |= ferror(file);
    int status = failed ? complain_of_system(p, "reading failed") : EXIT_DONE;
    fclose(file);
    p->at += (long long)p->to;
    return status;
}

static int complain_of_row(const part *p) {
    return complain(EXIT_INPUT, "%s: has other rows than the %lu it counts", p->path, p->rows);
}

/* The rest of the line at hand, as far as it is in the buffer; *ended if its end is. */
static int piece(field *out, int *ended, part *p) {
    int status = p->from == p->to ? refill(p) : EXIT_DONE;
    if (status)
        return status;
    const char *start = p->buffer + p->from, *end = memchr(start, '\n', p->to - p->from);
    *ended = end != NULL;
    *out = (field){start, end ? (size_t)(end + 1 - start) : p->to - p->from};
    p->from += out->length;
    return EXIT_DONE;
}

/* Add a piece to the row at hand. */
static int gather(part *p, field text) {
    if (p->row_capacity - p->row_length < text.length) {
        size_t capacity = 2 * (p->row_length + text.length);
        char *grown = realloc(p->row, capacity);
        if (!grown)
            return complain(EXIT_IO, "out of memory");
        p->row = grown;
        p->row_capacity = capacity;
    }
    memcpy(p->row + p->row_length, text.start, text.length);
    p->row_length += text.length;
    return EXIT_DONE;
}

/* The next line with its end. It is where the buffer has all of it, else put together. */
static int next_part_line(part *p, field *line) {
    int ended, status = piece(line, &ended, p);
    if (status || ended || !line->length)
        return status;
    p->row_length = 0;
    for (;;) {
        status = gather(p, *line);
        if (status || ended)
            break;
        status = piece(line, &ended, p);
        if (!status && !line->length)
            return EXIT_DONE;
        if (status)
            break;
    }
    *line = (field){p->row, p->row_length};
    return status;
}

/* What is expected of a row that graze classify has not written, else NULL. */
static const char *wrong_part(part *p, graze_context *context, field row) {
    row_parts parts;
    const char *expected = memchr(row.start, '\0', row.length)
                               ? "no byte 0"
                               : row_check(&parts, &p->form, context, row);
    if (expected)
        return expected;
    if (!row_point_is_written(parts.point, p->form.dimension))
        return "coordinates such as -12 or 22/7";
    if (p->form.others && fields_count(parts.rest) != p->form.others)
        return "as many further columns as the column line has";
    return NULL;
}

int part_copy_row(part *p, output *out, graze_context *context) {
    field line;
    int status = next_part_line(p, &line);
    if (status)
        return status;
    p->line++;
    if (!line.length || *line.start == '#' || line.start[line.length - 1] != '\n')
        return complain_of_row(p);
    const char *expected = wrong_part(p, context, (field){line.start, line.length - 1});
    if (expected)
        return complain(EXIT_INPUT, "%s:%lu: is no row that graze classify writes; expected %s",
                        p->path, p->line, expected);
    output_bytes(out, line.start, line.length);
    return EXIT_DONE;
}

int part_end(part *p) {
    field text;
    int ended, status = piece(&text, &ended, p);
    if (status)
        return status;
    return text.length && *text.start == '#' ? EXIT_DONE : complain_of_row(p);
}

/* Take one line of the head; the one that names the shard is left out. */
static int take_head(part *p, const char *line, size_t length, int *named) {
    size_t tag = strlen(SHARD_LINE);
    if (!*named && length > tag && memcmp(line, SHARD_LINE, tag) == 0) {
        char text[32] = "";
        size_t n = length - tag - 1;
        memcpy(text, line + tag, n < sizeof text ? n : sizeof text - 1);
        *named = shard_read(&p->shard, text);
        return EXIT_DONE;
    }
    char *grown = realloc(p->head, p->head_length + length + 1);
    if (!grown)
        return complain(EXIT_IO, "out of memory");
    memcpy(grown + p->head_length, line, length);
    p->head = grown;
    p->head_length += length;
    p->head[p->head_length] = '\0';
    return EXIT_DONE;
}

static int read_part_head(part *p, FILE *file) {
    char *line = NULL;
    size_t room = 0;
    ssize_t length = 1;
    int status = EXIT_DONE, named = 0, ended = 0;
    while (!status && !ended && (length = getline(&line, &room, file)) > 0) {
        if (p->at == 0 && strncmp(line, "# graze ", 8) != 0)
            break;
        ended = *line != '#' && line[length - 1] == '\n';
        p->at += length;
        p->line++;
        status = memchr(line, '\0', (size_t)length)
                     ? complain(EXIT_INPUT, "%s:%lu: a byte 0 in a text file", p->path, p->line)
                     : take_head(p, line, (size_t)length, &named);
    }
    int failed = length <= 0 && !feof(file); /* also where getline had no memory */
    if (failed && !status)
        status = complain_of_system(p, "reading failed");
    free(line);
    if (status)
        return status;
    if (p->at == 0)
        return complain(EXIT_INPUT, "%s: expected a table of graze classify", p->path);
    if (!named)
        return complain(EXIT_INPUT,
                        "%s: has no line `" SHARD_LINE "i/n` in its head; expected a "
                        "table of graze classify --shard i/n",
                        p->path);
    if (!row_form_read(&p->form, p->head ? p->head : ""))
        return complain(EXIT_INPUT,
                        "%s:%lu: is not the column line of graze classify: expected coordinates "
                        "and answers, and then the further columns",
                        p->path, p->line);
    return EXIT_DONE;
}

/* Take a line `key value` from the front of a text; 0 if another one stands there. */
static int take_value(field *value, const char **at, const char *key) {
    size_t length = strlen(key);
    const char *end = strncmp(*at, key, length) == 0 ? strchr(*at + length, '\n') : NULL;
    if (!end)
        return 0;
    *value = (field){*at + length, (size_t)(end - *at) - length};
    *at = end + 1;
    return 1;
}

/* A whole number behind a key, of digits alone. */
static int read_count(unsigned long *out, field value) {
    char text[24];
    if (value.length >= sizeof text)
        return 0;
    memcpy(text, value.start, value.length);
    text[value.length] = '\0';
    return numbers_count(out, text, 0);
}

/* The last lines are `# rows-of-all-shards R`, `# points-checksum H` and `# complete N`. */
static int read_tail(part *p, FILE *file) {
    char tail[TAIL + 1];
    field all, points, rows;
    long long start = p->size > TAIL ? p->size - TAIL : 0;
    if (fseeko(file, (off_t)start, SEEK_SET) != 0)
        return complain_of_system(p, "reading failed");
    size_t length = fread(tail, 1, TAIL, file);
    if (ferror(file))
        return complain_of_system(p, "reading failed");
    tail[length] = '\0';
    const char *found = strstr(tail, "\n" SHARD_ROWS), *at = found ? found + 1 : "";
    if (!take_value(&all, &at, SHARD_ROWS) || !take_value(&points, &at, SHARD_POINTS) ||
        !take_value(&rows, &at, "# complete ") || at != tail + length ||
        !read_count(&p->rows_of_all, all) || !read_count(&p->rows, rows))
        return complain(EXIT_INPUT,
                        "%s: does not end with `# complete`: the run was interrupted; graze "
                        "classify --resume continues it",
                        p->path);
    size_t n = points.length;
    memcpy(p->checksum, points.start, n < sizeof p->checksum ? n : sizeof p->checksum - 1);
    unsigned long dealt = shard_rows(p->shard, p->rows_of_all);
    if (p->rows != dealt)
        return complain(EXIT_INPUT, "%s: counts %lu rows; expected %lu of %lu in all", p->path,
                        p->rows, dealt, p->rows_of_all);
    return EXIT_DONE;
}

int part_open(part *p, const char *path) {
    struct stat about;
    memset(p, 0, sizeof *p);
    p->path = path;
    if (stat(path, &about) == 0 && !S_ISREG(about.st_mode))
        return complain(EXIT_IO,
                        "%s: expected a plain file; parts are read in turn, which a pipe "
                        "does not allow",
                        path);
    FILE *file = fopen(path, "r");
    if (!file)
        return complain_of_system(p, "cannot be opened");
    int status = EXIT_DONE;
    if (fstat(fileno(file), &about) != 0)
        status = complain_of_system(p, "cannot be opened");
    p->size = (long long)about.st_size;
    p->buffer = malloc(BUFFER);
    if (!status && !p->buffer)
        status = complain(EXIT_IO, "out of memory");
    if (!status)
        status = read_part_head(p, file);
    if (!status)
        status = read_tail(p, file);
    fclose(file);
    return status;
}

void part_close(part *p) {
    free(p->head);
    free(p->buffer);
    free(p->row);
}
