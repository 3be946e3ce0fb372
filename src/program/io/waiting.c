/* The seconds a command has worked. SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/io/io.h"

#include <stdio.h>
#include <unistd.h>

static double begun = -1; /* start of the wait; below 0: none, or no terminal */
static long shown;        /* seconds in the line; 0: there is no line */

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
