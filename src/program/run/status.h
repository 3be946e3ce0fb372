/* Exit status and messages of the programs.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_STATUS_H
#define GRAZE_RUN_STATUS_H

#include "graze.h"

/** Exit status (src/program/cli/formats.md, Exit status). */
enum {
    EXIT_DONE = 0,
    EXIT_NO = 1,
    EXIT_USAGE = 2,
    EXIT_INPUT = 3,
    EXIT_FAULT = 4,
    EXIT_IO = 5,
    EXIT_LIMIT = 6,
    EXIT_SIGNAL = 128 /* the caller dies of the signal that came */
};

/** Write `graze: MESSAGE` and a line end to standard error; returns `status`. With EXIT_LIMIT the
 * option that raises the limit stands behind the message. */
int complain(int status, const char *format, ...) __attribute__((format(printf, 2, 3)));

/** Write no more of what complain is called for with EXIT_DONE: notes. */
void complain_of_faults_alone(void);

/** The context's message without the name of the public function that it begins with, which users
 * of commands do not know. Valid as long as the message. */
const char *complaint_of(const graze_context *context);

/** Write that message; returns the exit status of its cause (EXIT_SIGNAL for a cancel). */
int complain_of(graze_status status, const graze_context *context);

/** complain, where GRAZE_EUSE is a fault of the command line: EXIT_USAGE. */
int complain_of_use(graze_status status, const graze_context *context);

/** Exit status for a number or a point that was refused: that of a limit or of the machine, or
 * else `otherwise`. */
int exit_for(graze_status status, int otherwise);

#endif
