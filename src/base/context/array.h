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
 * @return 1; 0 if memory is short or the size in bytes exceeds size_t, and then nothing has changed
 */
int array_reserve(void *items, size_t *capacity, size_t count, size_t size);

/** As array_reserve; on failure return GRAZE_ESYSTEM with the message "out of memory for WHAT". */
graze_status array_grow(graze_context *context, void *items, size_t *capacity, size_t count,
                        size_t size, const char *what);

/** array_grow for an array and its capacity. */
#define ARRAY_GROW(context, array, capacity, count, what)                                          \
    array_grow(context, &(array), &(capacity), count, sizeof *(array), what)

/** Make room for one more entry of a list with the members item, count and capacity. */
#define LIST_GROW(context, list, what)                                                             \
    ARRAY_GROW(context, (list)->item, (list)->capacity, (list)->count + 1, what)

/** A comparison function as qsort takes it. */
typedef int array_order(const void *left, const void *right);

/** The order of two numbers, size_t. */
int array_compare_numbers(const void *left, const void *right);

/** Sort entries and keep one of each set of equal ones, at the front. @return the number kept */
size_t array_sort_once(void *items, size_t count, size_t size, array_order *order);

/** Find the first of some sorted entries that is not less than the key. @return its index, or
 * `count` if all entries are less */
size_t array_first(const void *key, const void *items, size_t count, size_t size,
                   array_order *order);

/** A list of numbers; a zeroed structure is an empty list. */
typedef struct numbers {
    size_t count, capacity, *item;
} numbers;

graze_status numbers_add(numbers *list, graze_context *context, size_t number, const char *what);
void numbers_clear(numbers *list);
/** Sort a list ascending and keep each number once. */
void numbers_sort(numbers *list);

#endif
