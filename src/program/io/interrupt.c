/* SIGINT, SIGTERM and SIGHUP end a run after whole rows, a want of memory ends it at once.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/io/io.h"

#include <flint/flint.h>
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <unistd.h>

static const struct {
    int number;
    const char *name;
} ending[] = {{SIGINT, "SIGINT"}, {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}};
enum { ENDING = sizeof ending / sizeof *ending };

static atomic_int arrived;

enum { LAST_SECONDS = 10 };

static void note(int signal_number) {
    atomic_store(&arrived, signal_number);
    alarm(LAST_SECONDS);
}

/* End the process by the signal that came, ten seconds later, since one call of another library may
 * take hours without a look at the signal. */
static void end_late(int alarm_number) {
    (void)alarm_number;
    signal(atomic_load(&arrived), SIG_DFL);
    raise(atomic_load(&arrived));
}

int interrupt_watch(void) {
    struct sigaction action = {0};
    sigemptyset(&action.sa_mask);
    action.sa_handler = SIG_IGN;
    int failed = sigaction(SIGPIPE, &action, NULL) | sigaction(SIGXFSZ, &action, NULL);
    action.sa_handler = end_late;
    failed |= sigaction(SIGALRM, &action, NULL);
    action.sa_handler = note;
    for (int k = 0; k < ENDING; k++) {
        struct sigaction before;
        failed |= sigaction(ending[k].number, NULL, &before);
        if (before.sa_handler != SIG_IGN) /* else nohup, or a shell's background */
            failed |= sigaction(ending[k].number, &action, NULL);
    }
    return failed;
}

int interrupt_signal(void) {
    return atomic_load(&arrived);
}

void interrupt_die(void) {
    int signal_number = interrupt_signal();
    for (int k = 0; k < ENDING; k++)
        if (ending[k].number == signal_number)
            complain(EXIT_SIGNAL, "ended by %s", ending[k].name);
    signal(signal_number, SIG_DFL);
    raise(signal_number);
}

/* Memory for GMP, MPFR and FLINT, which cannot go on without it. The program ends at once, since
 * other threads may be at work, whose memory cannot be freed. Rows not yet written are lost, and
 * the table lacks its last line. */
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
