/* How graze-check ends, and memory.
 * SPDX-License-Identifier: MIT
 *
 * graze-check ends at the first thing that is wrong: status 1, refuted; status 2, could not check.
 * There is no other way past a test that has not succeeded. What is made once is kept until then.
 */
#ifndef CHECK_ENDS_H
#define CHECK_ENDS_H

#include <stddef.h>

enum { VERIFIED = 0, REFUTED = 1, NOT_CHECKED = 2 };

/** Write `graze-check: refuted: MESSAGE`, or `not checked`, and end with this status. */
_Noreturn void end_with(int status, const char *format, ...) __attribute__((format(printf, 2, 3)));
#define refute(...) end_with(REFUTED, __VA_ARGS__)
#define give_up(...) end_with(NOT_CHECKED, __VA_ARGS__)
/** Where only the system, or this program, can be at fault. */
#define must(holds, ...) ((holds) ? (void)0 : give_up(__VA_ARGS__))

/** As realloc, for count items; gives up without memory. */
void *grow(void *old, size_t count, size_t size);

#endif
