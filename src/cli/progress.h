/* A line that grows on standard error, where it is a terminal.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CLI_PROGRESS_H
#define GRAZE_CLI_PROGRESS_H

#include <time.h>

typedef struct progress {
    time_t start, shown;
} progress;

void progress_start(progress *p);
/** Show how many rows are done, at most once a second. */
void progress_show(progress *p, unsigned long rows);
/** Show the end and close the line. */
void progress_end(progress *p, unsigned long rows);

#endif
