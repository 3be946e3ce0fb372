/* Blocks of rows, and faults.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/points/points.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"

int fault_set(fault *f, int status, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    f->status = status;
    f->message = length < 0 ? NULL : malloc((size_t)length + 1);
    if (f->message) {
        va_start(arguments, format);
        vsnprintf(f->message, (size_t)length + 1, format, arguments);
        va_end(arguments);
    }
    return status;
}

int fault_of(fault *f, graze_status status, const graze_context *context, int otherwise) {
    if (!status)
        return EXIT_DONE;
    if (status == GRAZE_ECANCELED)
        return f->status = EXIT_SIGNAL;
    return fault_set(f, exit_for(status, otherwise), "%s", complaint_of(context));
}

int fault_tell(const fault *f) {
    if (f->status == EXIT_DONE || f->status == EXIT_SIGNAL)
        return f->status;
    return complain(f->status, "%s", f->message ? f->message : "out of memory");
}

void fault_clear(fault *f) {
    free(f->message);
    *f = (fault){EXIT_DONE, NULL};
}

block *block_create(void) {
    return calloc(1, sizeof(block));
}

int block_add(block *b, field text, unsigned long number) {
    if (!array_reserve(&b->bytes, &b->capacity, b->used + text.length, 1))
        return 0;
    memcpy(b->bytes + b->used, text.start, text.length);
    b->lines[b->count++] = (line){b->used, text.length, number};
    b->used += text.length;
    return 1;
}

void block_reset(block *b, unsigned long before) {
    size_t taken;
    for (size_t r = 0; r < b->count; r += taken ? taken : 1) {
        taken = b->runs[r].taken;
        for (int kind = 0; kind < RESULT_KINDS; kind++)
            graze_free(b->runs[r].out[kind].text);
        fault_clear(&b->runs[r].fault);
        memset(&b->runs[r], 0, sizeof b->runs[r]);
    }
    b->before = before;
    b->count = b->used = b->next = b->busy = 0;
    b->after = NULL;
}

void block_destroy(block *b) {
    if (!b)
        return;
    block_reset(b, 0);
    free(b->bytes);
    free(b);
}
