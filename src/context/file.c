/* Whole files in memory, with the SHA-256 of their bytes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>
#include <sha256.h>
#include "context/file.h"

void file_sha256(unsigned char sha256[32], const char *text, size_t length) {
    SHA256_CTX state;
    SHA256_Init(&state);
    SHA256_Update(&state, (const uint8_t *)text, length);
    SHA256_Final(sha256, &state);
}

static graze_status fail(graze_context *context, const char *path, const char *what, int error) {
    return context_fail(context, GRAZE_ESYSTEM, "%s: %s: %s", path, what, strerror(error));
}

/* Read to the end of `file`; `capacity` is a first guess that is right for files that do not grow.
 * Room for the NUL is always kept. */
static graze_status read_all(char **text, size_t *length, graze_context *context, const char *path,
                             int file, size_t capacity) {
    for (;;) {
        if (*length > context->limits[GRAZE_LIMIT_BYTES]) {
            return context_limit(context, GRAZE_LIMIT_BYTES, path);
        }
        if (*text == NULL || *length + 1 >= capacity) {
            capacity = *text == NULL ? capacity : 2 * capacity;
            char *larger = realloc(*text, capacity);
            if (larger == NULL) {
                return fail(context, path, "does not fit into memory", ENOMEM);
            }
            *text = larger;
        }
        ssize_t n = read(file, *text + *length, capacity - *length - 1);
        if (n == 0) {
            (*text)[*length] = '\0';
            return GRAZE_OK;
        }
        if (n > 0) {
            *length += (size_t)n;
        } else if (errno != EINTR) {
            return fail(context, path, "cannot be read", errno);
        }
    }
}

graze_status file_read(char **text, size_t *length, unsigned char sha256[32],
                       graze_context *context, const char *path) {
    *text = NULL;
    *length = 0;
    int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        return fail(context, path, "cannot be opened", errno);
    }
    struct stat about;
    graze_status status;
    if (fstat(file, &about) != 0) {
        status = fail(context, path, "cannot be read", errno);
    } else if (S_ISDIR(about.st_mode)) {
        status = fail(context, path, "cannot be read", EISDIR);
    } else if (S_ISREG(about.st_mode) &&
               (unsigned long long)about.st_size > context->limits[GRAZE_LIMIT_BYTES]) {
        status = context_limit(context, GRAZE_LIMIT_BYTES, path);
    } else {
        size_t guess = S_ISREG(about.st_mode) && about.st_size > 0 ? (size_t)about.st_size : 0;
        status = read_all(text, length, context, path, file, guess + 4096);
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
