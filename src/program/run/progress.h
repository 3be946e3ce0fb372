/* A line that grows on standard error, where it is a terminal: rows, rate and, where the end is
 * known, per cent and the time left.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_PROGRESS_H
#define GRAZE_RUN_PROGRESS_H

/** How far the work is: `done` of `whole`, in any unit; `whole` is 0 where it is unknown. */
typedef struct portion {
    unsigned long done, whole;
} portion;

typedef struct progress {
    int silent;
    double start, shown;  /* seconds of the monotonic clock */
    unsigned long rows;   /* rows at the start */
    unsigned long before; /* the portion done at the start */
} progress;

/** Seconds of the monotonic clock. */
double clock_seconds(void);

/** Begin, where `rows` rows are there already; `quiet` shows nothing. */
void progress_start(progress *p, int quiet, unsigned long rows, portion reached);
/** Show how many rows are there now, at most once a second. */
void progress_show(progress *p, unsigned long rows, portion reached);
/** Show the end and close the line. */
void progress_end(progress *p, unsigned long rows, portion reached);

#endif
