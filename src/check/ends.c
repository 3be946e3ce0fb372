/* How graze-check ends, and memory.
 * SPDX-License-Identifier: MIT
 */
#include "ends.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

void end_with(int status, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    fflush(stdout);
    fprintf(stderr, "graze-check: %s: ", status == REFUTED ? "refuted" : "not checked");
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(status);
}

void *grow(void *old, size_t count, size_t size) {
    void *out = count <= SIZE_MAX / 2 / size ? realloc(old, count * size + 1) : NULL;
    must(out != NULL, "out of memory for %zu items of %zu bytes", count, size);
    return out;
}
