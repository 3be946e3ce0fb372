/* A data race for test-all: two threads of Python that call bump at one time must be reported by
 * the thread sanitizer, else its silence about Graze says nothing. SPDX-License-Identifier:
 * GPL-3.0-or-later
 */
__attribute__((visibility("default"))) void bump(void);

static long count;

void bump(void) {
    for (int k = 0; k < 1000000; k++)
        count++;
}
