/* SIGINT, SIGTERM and SIGHUP as a flag that long work asks for.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_INTERRUPT_H
#define GRAZE_RUN_INTERRUPT_H

/** Catch these three, unless they are ignored already; ignore SIGPIPE and SIGXFSZ, so that a write
 * fails instead. A process that still works ten seconds after the signal dies of it. 0 on success.
 */
int interrupt_watch(void);

/** The signal that came, or 0. Any thread may ask. */
int interrupt_signal(void);

/** Report the signal that came and die of it, so that the shell sees it. */
void interrupt_die(void);

#endif
