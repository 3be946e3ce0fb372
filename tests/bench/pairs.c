/* First contacts of pairs measured in process, through graze.h alone.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Usage: pairs MOVING FIXED. Answers one line `key=value ...` when the solids are loaded, then one
 * a line of standard input:
 *   first MOTION    up to the first contact; hit is 0 or 1
 *   near MOTION     the same, at a clearance of 1/128
 *   whole MOTION    the whole word
 *   memory          the most bytes that the process has had in memory since the solids were loaded,
 *                   beyond those it had then
 * Times are CPU seconds of the process, motions read before.
 */
#include <string.h>
#include "graze.h"
#include "process.h"

typedef struct bench {
    graze_context *context;
    graze_solid *moving, *fixed;
    unsigned long loaded;
} bench;

static void check(graze_status status, const bench *b, const char *what) {
    if (status)
        fail(what, graze_context_message(b->context));
}

/* Let the highest number of pages begin anew. */
static void forget_peak(void) {
    FILE *file = fopen("/proc/self/clear_refs", "w");
    if (!file || fputs("5", file) < 0 || fclose(file))
        fail("/proc/self/clear_refs", "cannot be written");
}

static unsigned long peak(void) {
    char line[256];
    unsigned long kilobytes = 0;
    FILE *file = fopen("/proc/self/status", "r");
    while (file && fgets(line, sizeof line, file))
        if (sscanf(line, "VmHWM: %lu", &kilobytes) == 1)
            break;
    if (!file || !kilobytes)
        fail("/proc/self/status", "cannot be read");
    fclose(file);
    return 1024 * kilobytes;
}

static void query(const bench *b, const char *path, const char *verb) {
    graze_motion *motion;
    graze_pair *pair;
    mpq_t clearance;
    mpq_init(clearance);
    if (*verb == 'n')
        mpq_set_ui(clearance, 1, 128);
    const graze_pair_options options = {
        .size = sizeof options, .first = *verb != 'w', .clearance = clearance};
    check(graze_motion_read(&motion, b->context, path), b, path);
    double start = seconds();
    check(graze_pair_create(&pair, b->context, b->moving, motion, b->fixed, NULL, &options), b,
          path);
    printf("seconds=%.9f hit=%d verdict=%d\n", seconds() - start,
           graze_pair_get_verdict(pair) != GRAZE_PAIR_CLEAR, (int)graze_pair_get_verdict(pair));
    graze_pair_destroy(pair);
    graze_motion_destroy(motion);
    mpq_clear(clearance);
}

int main(int count, char **arguments) {
    bench b = {NULL, NULL, NULL, 0};
    char line[2048], verb[16], path[2000] = "";
    if (count != 3 || graze_context_create(&b.context))
        return 2;
    double start = seconds();
    check(graze_solid_read(&b.moving, b.context, arguments[1], 0), &b, arguments[1]);
    check(graze_solid_read(&b.fixed, b.context, arguments[2], 0), &b, arguments[2]);
    printf("load=%.9f\n", seconds() - start);
    fflush(stdout);
    b.loaded = resident();
    forget_peak();
    while (fgets(line, sizeof line, stdin)) {
        int words = sscanf(line, "%15s %1999s", verb, path);
        if (words == 2 && strstr("first near whole", verb))
            query(&b, path, verb);
        else if (words == 1 && strcmp(verb, "memory") == 0)
            printf("bytes=%ld\n", (long)(peak() - b.loaded));
        else
            fail(line, "no such command");
        fflush(stdout);
    }
    graze_solid_destroy(b.moving);
    graze_solid_destroy(b.fixed);
    graze_context_destroy(b.context);
    graze_thread_finish();
    return 0;
}
