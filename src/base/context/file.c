/* Whole files in memory, with the SHA-256 of their bytes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>
#include <sha256.h>
#include "base/context/array.h"
#include "base/context/file.h"
#include "base/context/input.h"
#include "base/context/scope.h"

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
        status =
            context_fail_in(context, GRAZE_ESYSTEM, path, 0, "cannot be read: %s", strerror(errno));
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
