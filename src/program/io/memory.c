/* Memory for GMP, MPFR and FLINT, which cannot go on without it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The program ends at once, since other threads may be at work, whose memory cannot be freed. Rows
 * not yet written are lost, and the table lacks its last line.
 */
#include "program/io/io.h"

#include <flint/flint.h>
#include <pthread.h>
#include <stdlib.h>
#include <unistd.h>

static void (*before_end)(void);

void memory_before_end(void (*what)(void)) {
    before_end = what;
}

/* Write one message and end the process. Other threads that come here wait at the lock. */
static _Noreturn void end_without_memory(void) {
    static pthread_mutex_t told = PTHREAD_MUTEX_INITIALIZER;
    static const char message[] = "graze: out of memory\n";
    pthread_mutex_lock(&told);
    ssize_t ignored = write(STDERR_FILENO, message, sizeof message - 1);
    (void)ignored;
    if (before_end)
        before_end();
    _exit(EXIT_IO);
}

static void *must_have(void *memory) {
    if (!memory)
        end_without_memory();
    return memory;
}

/* Allocate at least 1 byte, since malloc(0) may return NULL without a failure. */
static void *must_allocate(size_t size) {
    return must_have(malloc(size + !size));
}

static void *must_allocate_zeroed(size_t count, size_t size) {
    return must_have(calloc(count + !count, size + !size));
}

static void *must_resize(void *memory, size_t size) {
    return must_have(realloc(memory, size + !size));
}

static void *must_resize_known(void *memory, size_t before, size_t size) {
    (void)before;
    return must_resize(memory, size);
}

static void release_memory(void *memory, size_t size) {
    (void)size;
    free(memory);
}

void memory_guard(void) {
    mp_set_memory_functions(must_allocate, must_resize_known, release_memory);
    __flint_set_memory_functions(must_allocate, must_allocate_zeroed, must_resize, free);
}
