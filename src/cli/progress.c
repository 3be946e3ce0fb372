/* Progress of long work.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "cli/progress.h"

#include <stdio.h>
#include <unistd.h>

static void show(progress *p, unsigned long rows, const char *end) {
    p->shown = time(NULL);
    unsigned long seconds = (unsigned long)(p->shown - p->start);
    fprintf(stderr, "\r%lu rows, %lu rows/s   %s", rows, rows / (seconds ? seconds : 1), end);
}

void progress_start(progress *p) {
    p->start = p->shown = time(NULL);
}

void progress_show(progress *p, unsigned long rows) {
    if (isatty(STDERR_FILENO) && time(NULL) != p->shown)
        show(p, rows, "");
}

void progress_end(progress *p, unsigned long rows) {
    if (isatty(STDERR_FILENO))
        show(p, rows, "\n");
}
