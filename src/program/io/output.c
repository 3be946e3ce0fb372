/* Buffered output whose every failure is noticed: a full disk, a closed pipe, a late error at the
 * close.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/io/io.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/context/scope.h"

static const char *unnamed = "-"; /* NULL: standard error */

int output_is_standard(const char *path) {
    return path && *path == '-' && (!path[1] || path[1] == '.') && !strchr(path, '/');
}

const char *output_name(const char *path, const char *standard) {
    return path && strcmp(path, "-") == 0 ? standard : path;
}

void output_unnamed(const char *path) {
    unnamed = path;
}

/* Open a file with further flags of open(2). */
static int open_file(output *out, const char *path, int flags) {
    out->name = path;
    out->fd = open(path, flags | O_CREAT | O_CLOEXEC, 0666);
    return out->fd < 0
               ? complain(EXIT_IO, "%s: cannot be opened for writing: %s", path, strerror(errno))
               : EXIT_DONE;
}

int output_open(output *out, const char *path) {
    path = path ? path : unnamed;
    out->error = 0;
    out->used = out->open_line = 0;
    waiting_clear();
    if (path && !output_is_standard(path))
        return open_file(out, path, O_WRONLY | O_TRUNC);
    out->fd = path ? STDOUT_FILENO : STDERR_FILENO;
    out->name = path ? "standard output" : "standard error";
    return EXIT_DONE;
}

/* On a file system without locks the file counts as locked. */
int output_lock(output *out) {
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    if (fcntl(out->fd, F_SETLK, &whole) == 0 || (errno != EACCES && errno != EAGAIN))
        return EXIT_DONE;
    return complain(EXIT_IO, "%s: another run is writing it", out->name);
}

int output_continue(output *out, const char *path) {
    struct stat about;
    out->error = 0;
    out->used = out->open_line = 0;
    TRY(open_file(out, path, O_RDWR));
    if (fstat(out->fd, &about) == 0 && S_ISREG(about.st_mode))
        return EXIT_DONE;
    close(out->fd);
    return complain(EXIT_USAGE, "%s: expected a plain file, which alone can be continued", path);
}

void output_from(output *out, long long byte) {
    output_flush(out);
    if (!out->error &&
        (lseek(out->fd, (off_t)byte, SEEK_SET) < 0 || ftruncate(out->fd, (off_t)byte) != 0))
        out->error = errno;
    out->open_line = 0;
}

/* Update open_line after the first `done` bytes of the buffer were written. */
static void note_open_line(output *out, size_t done) {
    size_t k = done;
    while (k > 0 && out->buffer[k - 1] != '\n')
        k--;
    out->open_line = k ? done - k : out->open_line + done;
}

/* Remove the incomplete line that a failed write left at the end of a plain file. */
static void cut_open_line(const output *out) {
    struct stat about;
    off_t end = lseek(out->fd, 0, SEEK_CUR);
    if (!out->open_line || fstat(out->fd, &about) != 0 || !S_ISREG(about.st_mode) ||
        about.st_size != end)
        return;
    int ignored = ftruncate(out->fd, end - (off_t)out->open_line);
    (void)ignored; /* the failed write is reported anyway */
}

void output_flush(output *out) {
    size_t done = 0;
    while (done < out->used && !out->error) {
        ssize_t n = write(out->fd, out->buffer + done, out->used - done);
        if (n >= 0)
            done += (size_t)n;
        else if (errno != EINTR)
            out->error = errno;
    }
    note_open_line(out, done);
    if (out->error && done < out->used)
        cut_open_line(out);
    out->used = 0;
}

/* Write the whole lines of a full buffer and hold back the last line, which may go on. So the
 * output consists of whole lines whenever the program ends. */
static void flush_whole_lines(output *out) {
    size_t whole = out->used, rest;
    while (whole > 0 && out->buffer[whole - 1] != '\n')
        whole--;
    if (whole == 0)
        whole = out->used;
    rest = out->used - whole;
    out->used = whole;
    output_flush(out);
    memmove(out->buffer, out->buffer + whole, rest);
    out->used = rest;
}

void output_bytes(output *out, const char *text, size_t length) {
    while (length && !out->error) {
        size_t room = sizeof out->buffer - out->used;
        size_t part = length < room ? length : room;
        memcpy(out->buffer + out->used, text, part);
        out->used += part;
        text += part;
        length -= part;
        if (out->used == sizeof out->buffer)
            flush_whole_lines(out);
    }
}

void output_put(output *out, const char *text) {
    output_bytes(out, text, strlen(text));
}

void output_format(output *out, const char *format, ...) {
    char line[256];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    output_put(out, line);
}

void output_sink(void *out, const char *text, size_t length) {
    output_bytes(out, text, length);
}

void output_number(output *out, const mpq_t value) {
    char *text = mpq_get_str(NULL, 10, value);
    output_put(out, text);
    void (*release)(void *, size_t);
    mp_get_memory_functions(NULL, NULL, &release);
    release(text, strlen(text) + 1);
}

void output_drop(output *out) {
    struct stat about;
    out->used = out->open_line = 0;
    if (out->fd == STDOUT_FILENO || fstat(out->fd, &about) != 0 || !S_ISREG(about.st_mode))
        return;
    if (ftruncate(out->fd, 0) != 0 && !out->error)
        out->error = errno;
}

int output_close(output *out) {
    output_flush(out);
    if (out->fd != STDERR_FILENO && close(out->fd) != 0 && !out->error)
        out->error = errno;
    if (out->error)
        return complain(EXIT_IO, "%s: writing failed: %s", out->name, strerror(out->error));
    return EXIT_DONE;
}

int output_end(output *out, int status) {
    int closed = output_close(out);
    return status ? status : closed;
}

int output_text(const char *path, const char *text) {
    FREED(output, out, malloc(sizeof *out));
    if (!out)
        return complain(EXIT_IO, "out of memory");
    TRY(output_open(out, path));
    output_put(out, text);
    return output_close(out);
}

int output_made(const char *path, const text *made) {
    return made->failed ? complain(EXIT_IO, "out of memory") : output_text(path, made->data);
}

void output_guard_standard(void) {
    static const int wrong_way[] = {O_WRONLY, O_RDONLY, O_WRONLY};
    for (int fd = 0; fd < 3; fd++)
        if (fcntl(fd, F_GETFD) < 0 && errno == EBADF)
            if (open("/dev/null", wrong_way[fd]) < 0)
                return;
}

int path_has_extension(const char *path, const char *extension) {
    size_t length = strlen(path), tail = strlen(extension);
    return length > tail && strcmp(path + length - tail, extension) == 0;
}
