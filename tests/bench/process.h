/* CPU time and memory of the process that is measured.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TESTS_BENCH_PROCESS_H
#define GRAZE_TESTS_BENCH_PROCESS_H

#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

static inline double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static inline _Noreturn void fail(const char *what, const char *why) {
    fprintf(stderr, "bench: %s: %s\n", what, why);
    exit(1);
}

/* Bytes of the process in memory, what malloc could give back given back. */
static inline unsigned long resident(void) {
    unsigned long size = 0, pages = 0;
    malloc_trim(0);
    FILE *file = fopen("/proc/self/statm", "r");
    if (!file || fscanf(file, "%lu %lu", &size, &pages) != 2)
        fail("/proc/self/statm", "cannot be read");
    fclose(file);
    return pages * (unsigned long)sysconf(_SC_PAGESIZE);
}

#endif
