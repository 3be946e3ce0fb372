/* Allocations that fail, for the one source of a test in C that includes this.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * malloc, calloc and realloc stand here in front of the C library's. They fail for callers within
 * this program, which holds the library's own code; GMP and FLINT would abort, and all of them are
 * left alone. Sanitizers bring their own malloc, so nothing fails there. The names __libc_malloc
 * and so on are those of the GNU C library.
 */
#ifndef GRAZE_TESTS_LIB_FAILING_H
#define GRAZE_TESTS_LIB_FAILING_H

#include <stddef.h>
#include <stdint.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SANITIZED 1
#endif
#endif
#ifndef SANITIZED
#define SANITIZED 0
#endif

/* Allocations left until one fails; below zero none does. */
static long left = -1;

#if !SANITIZED
extern char __executable_start, etext;
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *memory, size_t size);

static int fails_for(const void *caller) {
    uintptr_t at = (uintptr_t)caller;
    if (left < 0 || at < (uintptr_t)&__executable_start || at >= (uintptr_t)&etext)
        return 0;
    return left-- == 0;
}

void *malloc(size_t size) {
    return fails_for(__builtin_return_address(0)) ? NULL : __libc_malloc(size);
}

void *calloc(size_t count, size_t size) {
    return fails_for(__builtin_return_address(0)) ? NULL : __libc_calloc(count, size);
}

void *realloc(void *memory, size_t size) {
    return fails_for(__builtin_return_address(0)) ? NULL : __libc_realloc(memory, size);
}
#endif

#endif
