/* A data race for threads.sh: two threads of Python that call bump at one time must be reported by
 * the thread sanitizer, else its silence about Graze says nothing. SPDX-License-Identifier:
 * GPL-3.0-or-later
 */
#include <sched.h>

__attribute__((visibility("default"))) void bump(void);

static int calls, counted;
static long count;

static void wait_for(int number) {
    while (__atomic_load_n(&counted, __ATOMIC_RELAXED) < number)
        sched_yield();
}

/* One counts after the other: of two counts in one instant the sanitizer may see neither. Both are
 * within the call then: one that had ended would come before the other by the interpreter's lock.
 * Relaxed counters order nothing. */
void bump(void) {
    int before = __atomic_fetch_add(&calls, 1, __ATOMIC_RELAXED);

    wait_for(before);
    count++;
    __atomic_add_fetch(&counted, 1, __ATOMIC_RELAXED);
    wait_for(2);
}
