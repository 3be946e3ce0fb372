/* Progress of long work, and the seconds a command has worked.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/io/io.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

double clock_seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Put `, 12 %, 1:02:03 left`; nothing if the end is not known. */
static void put_time_left(const progress *p, portion reached, double seconds) {
    if (!reached.whole)
        return;
    double done = (double)reached.done, whole = (double)reached.whole;
    double since = done - (double)p->before;
    fprintf(stderr, ", %d %%", (int)(100 * (done < whole ? done / whole : 1)));
    if (since <= 0 || done >= whole)
        return;
    unsigned long left = (unsigned long)(seconds * (whole - done) / since);
    fprintf(stderr, ", %lu:%02lu:%02lu left", left / 3600, left / 60 % 60, left % 60);
}

static void show_progress(progress *p, unsigned long rows, portion reached, const char *end) {
    p->shown = clock_seconds();
    double seconds = p->shown - p->start;
    double rate = seconds > 0 ? (double)(rows - p->rows) / seconds : 0;
    fprintf(stderr, "\r%lu rows, %.0f rows/s", rows, rate);
    put_time_left(p, reached, seconds);
    fprintf(stderr, "%s%s", reached.whole ? "                " : "   ", end);
}

void progress_start(progress *p, int quiet, unsigned long rows, portion reached) {
    p->silent = quiet || !isatty(STDERR_FILENO);
    p->start = p->shown = clock_seconds();
    p->rows = rows;
    p->before = reached.done;
}

void progress_show(progress *p, unsigned long rows, portion reached) {
    if (!p->silent && clock_seconds() - p->shown >= 1)
        show_progress(p, rows, reached, "");
}

void progress_end(progress *p, unsigned long rows, portion reached) {
    if (!p->silent)
        show_progress(p, rows, reached, "\n");
}

static double begun = -1;  /* start of the wait; below 0: none, or no terminal */
static _Atomic long shown; /* seconds in the line; 0: there is no line */

void waiting_start(void) {
    if (isatty(STDERR_FILENO))
        begun = clock_seconds();
}

void waiting_show(void) {
    long seconds = begun < 0 ? 0 : (long)(clock_seconds() - begun);
    if (seconds < 2 || seconds == shown)
        return;
    shown = seconds;
    fprintf(stderr, "\rworking, %ld s", shown);
}

void waiting_clear(void) {
    if (shown)
        fprintf(stderr, "\r%32s\r", "");
    shown = 0;
}
