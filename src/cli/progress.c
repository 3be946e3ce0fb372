/* Progress of long work.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "cli/progress.h"

#include <stdio.h>
#include <unistd.h>

/* `, 12 %, 1:02:03 left`; nothing where the end is not known. */
static void put_rest(const progress *p, portion reached, double seconds) {
    if (!reached.whole)
        return;
    double done = (double)reached.done, whole = (double)reached.whole;
    double now = done - (double)p->before;
    fprintf(stderr, ", %d %%", (int)(100 * (done < whole ? done / whole : 1)));
    if (now <= 0 || done >= whole)
        return;
    unsigned long left = (unsigned long)(seconds * (whole - done) / now);
    fprintf(stderr, ", %lu:%02lu:%02lu left", left / 3600, left / 60 % 60, left % 60);
}

static void show(progress *p, unsigned long rows, portion reached, const char *end) {
    p->shown = time(NULL);
    unsigned long seconds = (unsigned long)(p->shown - p->start);
    fprintf(stderr, "\r%lu rows, %lu rows/s", rows, (rows - p->rows) / (seconds ? seconds : 1));
    put_rest(p, reached, (double)seconds);
    fprintf(stderr, "%s%s", reached.whole ? "                " : "   ", end);
}

void progress_start(progress *p, int quiet, unsigned long rows, portion reached) {
    p->silent = quiet || !isatty(STDERR_FILENO);
    p->start = p->shown = time(NULL);
    p->rows = rows;
    p->before = reached.done;
}

void progress_show(progress *p, unsigned long rows, portion reached) {
    if (!p->silent && time(NULL) != p->shown)
        show(p, rows, reached, "");
}

void progress_end(progress *p, unsigned long rows, portion reached) {
    if (!p->silent)
        show(p, rows, reached, "\n");
}
