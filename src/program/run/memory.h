/* The end of the program where memory runs out and no status can be returned.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_RUN_MEMORY_H
#define GRAZE_RUN_MEMORY_H

/** Have GMP, MPFR and FLINT end the program with a message and EXIT_IO when they get no memory.
 * By default they abort, and FLINT's message would be written into the table. To be called before
 * their first use. */
void memory_guard(void);

/** Call `what` before such an end; NULL: nothing. It runs in any thread and may use neither memory
 * nor locks. */
void memory_before_end(void (*what)(void));

#endif
