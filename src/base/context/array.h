/* Arrays that grow. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_CONTEXT_ARRAY_H
#define GRAZE_CONTEXT_ARRAY_H

#include <stddef.h>
#include "graze/core.h"

/**
 * Make room for `count` entries of `size` bytes. The room at least doubles when it grows, so that
 * appending one by one takes linear time.
 * @param items    the address of a pointer to entries, NULL or malloc'ed
 * @param capacity the entries there is room for
 * @return 1, or 0 without memory or beyond what size_t counts; then nothing has changed
 */
int array_reserve(void *items, size_t *capacity, size_t count, size_t size);

/** array_reserve with a status: a failure is GRAZE_ESYSTEM, "out of memory for WHAT". */
graze_status array_grow(graze_context *context, void *items, size_t *capacity, size_t count,
                        size_t size, const char *what);

#endif
