/* The seconds a command has worked, on standard error where it is a terminal.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * For commands whose work has no rows to count. One thread uses these functions.
 */
#ifndef GRAZE_RUN_WAITING_H
#define GRAZE_RUN_WAITING_H

/** From now on waiting_show shows the time since then; until then it does nothing. */
void waiting_start(void);
/** Show the seconds, once a second, from the second one on. */
void waiting_show(void);
/** Take the line away, so that a message or an answer can stand there. */
void waiting_clear(void);

#endif
