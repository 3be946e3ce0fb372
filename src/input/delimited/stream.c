/* Reads lines through a buffer that grows only for a long line.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/delimited/delimited.h"

#include <errno.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/context/array.h"
#include "base/context/file.h"
#include "base/context/scope.h"

/* Bytes of the buffer at first; fewer for a file that is reopened, since there may be many. */
enum { BUFFER = 1 << 16, BUFFER_OF_MANY = 1 << 14 };

static graze_status stream_no_memory(graze_context *context) {
    return context_fail(context, GRAZE_ESYSTEM, "out of memory");
}

static graze_status make_buffer(stream *s, size_t capacity) {
    s->buffer = malloc(capacity);
    s->capacity = capacity;
    return s->buffer ? GRAZE_OK : stream_no_memory(s->context);
}

graze_status stream_open(stream *out, graze_context *context, const char *path) {
    int standard = strcmp(path, "-") == 0;
    *out = (stream){.context = context,
                    .name = standard ? "standard input" : path,
                    .limit = context->limits[GRAZE_LIMIT_LINE]};
    graze_status status =
        standard ? input_standard(&out->fd, context) : input_open(&out->fd, context, path);
    return status ? status : make_buffer(out, BUFFER);
}

graze_status stream_open_own(stream *out, graze_context *context, const char *path, int reopened) {
    *out = (stream){
        .context = context, .name = path, .fd = -1, .reopened = reopened, .own = 1, .limit = ~0ul};
    TRY(reopened ? GRAZE_OK : input_open(&out->fd, context, path));
    return make_buffer(out, reopened ? BUFFER_OF_MANY : BUFFER);
}

void stream_of_text(stream *out, graze_context *context, const char *name, const char *text,
                    size_t length) {
    *out = (stream){.context = context,
                    .name = name,
                    .fd = -1,
                    .ended = 1,
                    .buffer = (char *)text,
                    .to = length,
                    .limit = ~0ul};
}

void stream_close(stream *s) {
    if (s->fd > STDIN_FILENO)
        close(s->fd);
    if (s->capacity)
        free(s->buffer);
    s->fd = -1;
    s->buffer = NULL;
}

int stream_repeatable(const stream *s) {
    struct stat about;
    return s->fd > STDIN_FILENO && fstat(s->fd, &about) == 0 && S_ISREG(about.st_mode);
}

static graze_status check_line_length(const stream *s, size_t length, unsigned long line) {
    if (length <= s->limit)
        return GRAZE_OK;
    graze_status status = context_limit(s->context, GRAZE_LIMIT_LINE, "the bytes of one line");
    return context_in(s->context, status, s->name, line);
}

/* Make room behind the unused bytes, which are the beginning of one line. */
static graze_status make_line_room(stream *s) {
    memmove(s->buffer, s->buffer + s->from, s->to - s->from);
    s->to -= s->from;
    s->from = 0;
    graze_status status = check_line_length(s, s->to, s->line + 1);
    if (status || s->to < s->capacity)
        return status;
    return array_reserve(&s->buffer, &s->capacity, s->capacity + 1, 1)
               ? GRAZE_OK
               : stream_no_memory(s->context);
}

static graze_status seek(const stream *s, int fd) {
    if (lseek(fd, (off_t)s->offset, SEEK_SET) >= 0)
        return GRAZE_OK;
    return context_fail_in(s->context, GRAZE_ESYSTEM, s->name, 0, "reading failed: %s",
                           strerror(errno));
}

static graze_status read_more(stream *s) {
    int fd = s->fd;
    size_t n = 0;
    graze_status status = make_line_room(s);
    if (!status && s->reopened)
        status = input_open(&fd, s->context, s->name);
    if (!status && s->reopened)
        status = seek(s, fd);
    if (!status)
        status = input_read(&n, s->context, s->name, fd, s->buffer + s->to, s->capacity - s->to);
    if (s->reopened && fd >= 0)
        close(fd);
    if (status)
        return status;
    s->ended = n == 0;
    s->to += n;
    s->offset += (long long)n;
    return GRAZE_OK;
}

int stream_ready(stream *s) {
    while (!s->ended && !memchr(s->buffer + s->from, '\n', s->to - s->from)) {
        struct pollfd one = {s->fd, POLLIN, 0};
        if (poll(&one, 1, 0) <= 0)
            return 0;
        if (read_more(s))
            return 1; /* stream_next meets the same failure */
    }
    return 1;
}

/* Drop the CR at the end of a line and, in line 1, the byte order mark. */
static field stripped(const stream *s, field line) {
    if (line.length && line.start[line.length - 1] == '\r')
        line.length--;
    if (s->line == 1 && line.length >= 3 && memcmp(line.start, "\xef\xbb\xbf", 3) == 0)
        line = (field){line.start + 3, line.length - 3};
    return line;
}

graze_status stream_next(stream *s, field *out) {
    size_t seen = 0;
    const char *end = NULL;
    *out = (field){NULL, 0};
    while (!end) {
        size_t there = s->to - s->from;
        if (there > seen)
            end = memchr(s->buffer + s->from + seen, '\n', there - seen);
        seen = there;
        if (end || s->ended)
            break;
        TRY(read_more(s));
    }
    s->whole = end != NULL;
    if (!end && s->from == s->to)
        return GRAZE_OK;
    const char *at = s->buffer + s->from;
    field line = {at, end ? (size_t)(end - at) : s->to - s->from};
    s->from += line.length + (end != NULL);
    s->line++;
    if (!s->own)
        line = stripped(s, line);
    *out = line;
    return check_line_length(s, line.length, s->line);
}

void stream_copy_line(text *to, const stream *s, field line) {
    text_bytes(to, line.start, line.length);
    if (s->whole)
        text_put(to, "\n");
}

long long stream_tell(const stream *s) {
    return s->offset - (long long)(s->to - s->from);
}

graze_status stream_seek(stream *s, long long offset) {
    s->offset = offset;
    s->from = s->to = 0;
    s->ended = 0;
    return s->reopened ? GRAZE_OK : seek(s, s->fd);
}

graze_status stream_beginning(char *text, size_t room, size_t *length, graze_context *context,
                              const char *path) {
    int fd;
    size_t n = 1;
    *length = 0;
    graze_status status = input_open(&fd, context, path);
    while (!status && n && *length + 1 < room) {
        status = input_read(&n, context, path, fd, text + *length, room - 1 - *length);
        *length += status ? 0 : n;
    }
    text[*length] = '\0';
    if (fd >= 0)
        close(fd);
    return status;
}
