/* Reads a part of a table (part.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "cli/part.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "cli/cli.h"
#include "cli/fields.h"

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
    return complain(EXIT_INPUT, "%s: does not have the %lu rows it says it has", p->path, p->rows);
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

int part_copy_row(part *p, output *out) {
    field text;
    int status, ended = 0;
    for (int first = 1; !ended; first = 0) {
        if ((status = piece(&text, &ended, p)) != EXIT_DONE)
            return status;
        if (!text.length || (first && *text.start == '#'))
            return complain_of_row(p);
        output_bytes(out, text.start, text.length);
    }
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

static int read_head(part *p, FILE *file) {
    char *line = NULL;
    size_t room = 0;
    ssize_t length = 1;
    int status = EXIT_DONE, named = 0, ended = 0;
    while (!status && !ended && (length = getline(&line, &room, file)) > 0) {
        if (p->at == 0 && strncmp(line, "# graze ", 8) != 0)
            break;
        ended = *line != '#' && line[length - 1] == '\n';
        p->at += length;
        if (memchr(line, '\0', (size_t)length))
            status = complain(EXIT_INPUT, "%s: has a NUL byte in its head; expected text", p->path);
        else
            status = take_head(p, line, (size_t)length, &named);
    }
    free(line);
    if (status)
        return status;
    if (ferror(file))
        return complain_of_system(p, "reading failed");
    if (p->at == 0)
        return complain(EXIT_INPUT, "%s: is no table of graze classify", p->path);
    if (!named)
        return complain(EXIT_INPUT,
                        "%s: has no line `" SHARD_LINE "i/n` in its head: right is a "
                        "table of graze classify --shard i/n",
                        p->path);
    return EXIT_DONE;
}

/* The value behind a key in the last bytes of the file, or NULL. */
static const char *find(const char *tail, const char *key) {
    const char *at = strstr(tail, key);
    return at ? at + strlen(key) : NULL;
}

/* The last lines are `# rows-of-all-shards R`, `# points-checksum H` and `# complete N`. */
static int read_tail(part *p, FILE *file) {
    char tail[TAIL + 1];
    long long start = p->size > TAIL ? p->size - TAIL : 0;
    if (fseeko(file, (off_t)start, SEEK_SET) != 0)
        return complain_of_system(p, "reading failed");
    size_t length = fread(tail, 1, TAIL, file);
    tail[length] = '\0';
    const char *all = find(tail, "\n" SHARD_ROWS);
    const char *points = all ? find(all, "\n" SHARD_POINTS) : NULL;
    const char *rows = points ? find(points, "\n# complete ") : NULL;
    if (!rows || tail[length - 1] != '\n')
        return complain(EXIT_INPUT,
                        "%s: does not end with `# complete`: the run was interrupted; graze "
                        "classify --resume continues it",
                        p->path);
    p->rows_of_all = strtoul(all, NULL, 10);
    p->rows = strtoul(rows, NULL, 10);
    size_t n = strcspn(points, "\n");
    memcpy(p->checksum, points, n < sizeof p->checksum ? n : sizeof p->checksum - 1);
    unsigned long right = shard_rows(p->shard, p->rows_of_all);
    if (p->rows != right)
        return complain(EXIT_INPUT, "%s: says it has %lu rows; of %lu in all its shard has %lu",
                        p->path, p->rows, p->rows_of_all, right);
    return EXIT_DONE;
}

int part_open(part *p, const char *path) {
    struct stat about;
    memset(p, 0, sizeof *p);
    p->path = path;
    FILE *file = fopen(path, "r");
    if (!file)
        return complain_of_system(p, "cannot be opened");
    int status = EXIT_DONE;
    if (fstat(fileno(file), &about) != 0 || !S_ISREG(about.st_mode))
        status = complain(EXIT_IO,
                          "%s: is no plain file; parts are read in turn, and of a pipe "
                          "that cannot be done",
                          path);
    else
        p->size = (long long)about.st_size;
    p->buffer = malloc(BUFFER);
    if (!status && !p->buffer)
        status = complain(EXIT_IO, "out of memory");
    if (!status)
        status = read_head(p, file);
    if (!status)
        status = read_tail(p, file);
    fclose(file);
    return status;
}

void part_close(part *p) {
    free(p->head);
    free(p->buffer);
}
