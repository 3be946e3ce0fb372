/* SIGINT and SIGTERM as a flag that long work asks for.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CLI_INTERRUPT_H
#define GRAZE_CLI_INTERRUPT_H

/** Catch SIGINT and SIGTERM, ignore SIGPIPE; 0 on success. */
int interrupt_watch(void);

/** The signal that came, or 0. Any thread may ask. */
int interrupt_signal(void);

/** Wait until `fd` can be read or a signal has come. */
void interrupt_wait(int fd);

/** 1 if `fd` can be read without waiting. */
int interrupt_ready(int fd);

/** Die of the signal that came, so that the shell sees it. */
void interrupt_die(void);

#endif
