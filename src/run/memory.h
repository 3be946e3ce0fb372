/* What becomes of the program when memory runs out where no status can say so.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_RUN_MEMORY_H
#define GRAZE_RUN_MEMORY_H

/** Have GMP, MPFR and FLINT end the program with a message and EXIT_IO when they get no memory.
 * Left to themselves they abort, and FLINT's message would stand in the table. To be called before
 * their first use. */
void memory_guard(void);

/** Have `what` called before such an end; NULL: nothing. Any thread may call it, so it must not ask
 * for memory nor for locks. */
void memory_before_end(void (*what)(void));

#endif
