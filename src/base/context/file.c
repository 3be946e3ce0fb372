/* Files and pipes, opened and read, whole ones with the SHA-256 of their bytes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A FIFO is opened without waiting for a writer, and a poll precedes every read: while there is
 * nothing to read, input_read waits in steps and asks the cancel callback at each. On Linux poll
 * reports neither data nor a hang-up until a first writer opens the FIFO, so a FIFO without a
 * writer is not taken for an empty file.
 */
#include "base/context/file.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <sha256.h>
#include <stdint.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>
#include "base/context/array.h"
#include "base/context/scope.h"

enum { STEP = 100 }; /* milliseconds */

static graze_status fail_input(graze_context *context, const char *name, const char *what) {
    return context_fail_in(context, GRAZE_ESYSTEM, name, 0, "%s: %s", what, strerror(errno));
}

/* Refuse directories and devices: a device may never end, and opening one may move a tape. */
static graze_status check_file_kind(graze_context *context, const char *path,
                                    const struct stat *about) {
    int directory = S_ISDIR(about->st_mode);
    if (!directory && !S_ISCHR(about->st_mode) && !S_ISBLK(about->st_mode))
        return GRAZE_OK;
    return context_fail_in(context, GRAZE_ESYSTEM, path, 0, "is a %s; expected a file or a pipe",
                           directory ? "directory" : "device");
}

graze_status input_open(int *fd, graze_context *context, const char *path) {
    struct stat about;
    *fd = -1;
    if (stat(path, &about) != 0)
        return fail_input(context, path, "cannot be opened");
    graze_status status = check_file_kind(context, path, &about);
    if (status)
        return status;
    *fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (*fd < 0)
        return fail_input(context, path, "cannot be opened");
    if (fstat(*fd, &about) != 0)
        status = fail_input(context, path, "cannot be read");
    else
        status = check_file_kind(context, path, &about); /* the file may have changed since stat */
    if (status) {
        close(*fd);
        *fd = -1;
    }
    return status;
}

graze_status input_standard(int *fd, graze_context *context) {
    struct stat about;
    *fd = STDIN_FILENO;
    return fstat(*fd, &about) == 0 && S_ISDIR(about.st_mode)
               ? check_file_kind(context, "standard input", &about)
               : GRAZE_OK;
}

graze_status input_read(size_t *got, graze_context *context, const char *name, int fd, char *to,
                        size_t room) {
    for (;;) {
        TRY(context_poll(context));
        struct pollfd one = {fd, POLLIN, 0};
        int ready = poll(&one, 1, STEP);
        if (ready < 0 && errno != EINTR)
            return fail_input(context, name, "cannot be waited for");
        if (ready <= 0)
            continue;
        ssize_t n = read(fd, to, room);
        if (n >= 0) {
            *got = (size_t)n;
            return GRAZE_OK;
        }
        if (errno != EINTR && errno != EAGAIN)
            return fail_input(context, name, "reading failed");
    }
}

void file_sha256(unsigned char sha256[32], const char *text, size_t length) {
    SHA256_CTX state;
    SHA256_Init(&state);
    SHA256_Update(&state, (const uint8_t *)text, length);
    SHA256_Final(sha256, &state);
}

/* Read to the end of `file`; `guess` is enough room for files that do not grow. Room for the NUL is
 * always kept. */
static graze_status read_stream(char **text, size_t *length, graze_context *context,
                                const char *path, int file, size_t guess) {
    size_t capacity = 0;
    for (;;) {
        if (*length > context->limits[GRAZE_LIMIT_BYTES])
            return context_limit(context, GRAZE_LIMIT_BYTES, path);
        size_t n;
        TRY(array_grow(context, text, &capacity, capacity ? *length + 2 : guess, 1, path));
        TRY(input_read(&n, context, path, file, *text + *length, capacity - *length - 1));
        if (n == 0) {
            (*text)[*length] = '\0';
            return GRAZE_OK;
        }
        *length += n;
    }
}

graze_status file_read(char **text, size_t *length, unsigned char sha256[32],
                       graze_context *context, const char *path) {
    *text = NULL;
    *length = 0;
    int file;
    TRY(input_open(&file, context, path));
    graze_status status;
    struct stat about;
    if (fstat(file, &about) != 0) {
        status = fail_input(context, path, "cannot be read");
    } else if (S_ISREG(about.st_mode) &&
               (unsigned long long)about.st_size > context->limits[GRAZE_LIMIT_BYTES]) {
        status = context_limit(context, GRAZE_LIMIT_BYTES, path);
    } else {
        size_t guess = S_ISREG(about.st_mode) && about.st_size > 0 ? (size_t)about.st_size : 0;
        status = read_stream(text, length, context, path, file, guess + 4096);
    }
    close(file);
    if (status != GRAZE_OK) {
        free(*text);
        *text = NULL;
        *length = 0;
        return status;
    }
    file_sha256(sha256, *text, *length);
    return GRAZE_OK;
}
