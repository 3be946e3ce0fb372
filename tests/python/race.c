/* A data race for test-all: two threads of Python that call bump at one time must be reported by
 * the thread sanitizer, else its silence about Graze says nothing. SPDX-License-Identifier:
 * GPL-3.0-or-later
 */
#include <sched.h>

__attribute__((visibility("default"))) void bump(void);

static int arrived;
static long count;

/* Each waits for the other: a call that had ended before the next began would come before it by the
 * interpreter's lock. A relaxed counter orders nothing. */
void bump(void) {
    __atomic_add_fetch(&arrived, 1, __ATOMIC_RELAXED);
    while (__atomic_load_n(&arrived, __ATOMIC_RELAXED) < 2)
        sched_yield();
    count++;
}
