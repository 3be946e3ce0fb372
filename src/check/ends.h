/* How graze-check ends, and memory.
 * SPDX-License-Identifier: MIT
 *
 * graze-check ends at the first thing that is wrong: status 1, refuted; status 2, could not check.
 * A test that does not succeed always ends the program. Objects that are made only once are not
 * freed before the end.
 */
#ifndef CHECK_ENDS_H
#define CHECK_ENDS_H

#include <stddef.h>

enum { VERIFIED = 0, REFUTED = 1, NOT_CHECKED = 2 };

/** Write `graze-check: refuted: MESSAGE`, or `not checked`, and end with this status. */
_Noreturn void end_with(int status, const char *format, ...) __attribute__((format(printf, 2, 3)));
#define refute(...) end_with(REFUTED, __VA_ARGS__)
#define give_up(...) end_with(NOT_CHECKED, __VA_ARGS__)
/** Give up unless the condition holds: for failures that only the system, or an error of this
 * program, can cause. */
#define must(holds, ...) ((holds) ? (void)0 : give_up(__VA_ARGS__))

/** realloc to `count` items of `size` bytes; gives up if memory is short. */
void *grow(void *old, size_t count, size_t size);

#endif
