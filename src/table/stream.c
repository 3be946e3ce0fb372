/* Lines out of a buffer that grows only for a long line.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "table/stream.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "context/input.h"

graze_status stream_open(stream *out, graze_context *context, const char *path) {
    int standard = strcmp(path, "-") == 0;
    memset(out, 0, sizeof *out);
    out->context = context;
    out->name = standard ? "standard input" : path;
    out->capacity = 1 << 16;
    out->fd = STDIN_FILENO;
    graze_status status = standard ? GRAZE_OK : input_open(&out->fd, context, path);
    if (status)
        return status;
    out->buffer = malloc(out->capacity);
    return out->buffer ? GRAZE_OK : context_fail(context, GRAZE_ESYSTEM, "out of memory");
}

void stream_close(stream *l) {
    if (l->fd > STDIN_FILENO)
        close(l->fd);
    free(l->buffer);
    l->fd = -1;
    l->buffer = NULL;
}

int stream_repeatable(const stream *l) {
    struct stat about;
    return l->fd > STDIN_FILENO && fstat(l->fd, &about) == 0 && S_ISREG(about.st_mode);
}

static graze_status check_length(const stream *l, size_t length, unsigned long line) {
    if (length <= l->context->limits[GRAZE_LIMIT_LINE])
        return GRAZE_OK;
    graze_status status = context_limit(l->context, GRAZE_LIMIT_LINE, "the bytes of one line");
    return context_at(l->context, status, "%s:%lu", l->name, line);
}

/* Room behind the unused bytes, which are part of one line. */
static graze_status make_room(stream *l) {
    memmove(l->buffer, l->buffer + l->from, l->to - l->from);
    l->to -= l->from;
    l->from = 0;
    graze_status status = check_length(l, l->to, l->line + 1);
    if (status || l->to < l->capacity)
        return status;
    char *grown = realloc(l->buffer, 2 * l->capacity);
    if (!grown)
        return context_fail(l->context, GRAZE_ESYSTEM, "out of memory");
    l->buffer = grown;
    l->capacity *= 2;
    return GRAZE_OK;
}

static graze_status read_more(stream *l) {
    graze_status status = make_room(l);
    size_t n;
    if (!status)
        status = input_read(&n, l->context, l->name, l->fd, l->buffer + l->to, l->capacity - l->to);
    if (status)
        return status;
    l->ended = n == 0;
    l->to += n;
    return GRAZE_OK;
}

graze_status stream_next(stream *l, field *out) {
    size_t seen = 0;
    char *end = NULL;
    *out = (field){NULL, 0};
    while (!end && !l->ended) {
        end = memchr(l->buffer + l->from + seen, '\n', l->to - l->from - seen);
        seen = l->to - l->from;
        graze_status status = end ? GRAZE_OK : read_more(l);
        if (status)
            return status;
    }
    if (!end && l->from == l->to)
        return GRAZE_OK;
    const char *at = l->buffer + l->from;
    size_t n = end ? (size_t)(end - at) : l->to - l->from;
    l->from += n + (end != NULL);
    l->line++;
    if (n && at[n - 1] == '\r')
        n--;
    if (l->line == 1 && n >= 3 && memcmp(at, "\xef\xbb\xbf", 3) == 0) {
        at += 3;
        n -= 3;
    }
    if (memchr(at, '\0', n))
        return context_fail(l->context, GRAZE_EINPUT, "%s:%lu: a byte 0 in a text file", l->name,
                            l->line);
    *out = (field){at, n};
    return check_length(l, n, l->line);
}
