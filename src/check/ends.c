/* How graze-check ends, and memory.
 * SPDX-License-Identifier: MIT
 */
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include "base.h"

static _Noreturn void end(int status, const char *verdict, const char *format, va_list arguments) {
    fflush(stdout);
    fprintf(stderr, "graze-check: %s: ", verdict);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    exit(status);
}

void refute(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    end(REFUTED, "refuted", format, arguments);
    // cppcheck-suppress va_end_missing
}

void give_up(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    end(NOT_CHECKED, "not checked", format, arguments);
    // cppcheck-suppress va_end_missing
}

void *grow(void *old, size_t count, size_t size) {
    void *out = count <= SIZE_MAX / 2 / size ? realloc(old, count ? count * size : 1) : NULL;
    if (!out)
        give_up("out of memory for %zu items of %zu bytes", count, size);
    return out;
}
