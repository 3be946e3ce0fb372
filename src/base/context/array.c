/* Arrays that grow. SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/array.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/context.h"

enum { LEAST_BYTES = 256 };

int array_reserve(void *items, size_t *capacity, size_t count, size_t size) {
    if (count <= *capacity)
        return 1;
    size_t most = SIZE_MAX / size, room = *capacity > most / 2 ? most : 2 * *capacity;
    if (count > most)
        return 0;
    if (room < LEAST_BYTES / size)
        room = LEAST_BYTES / size;
    if (room < count)
        room = count;
    void *old, *grown; /* all pointers to objects have one representation */
    memcpy(&old, items, sizeof old);
    grown = realloc(old, room * size);
    if (!grown)
        return 0;
    memcpy(items, &grown, sizeof grown);
    *capacity = room;
    /* cppcheck-suppress memleak; the caller has it */
    return 1;
}

graze_status array_grow(graze_context *context, void *items, size_t *capacity, size_t count,
                        size_t size, const char *what) {
    return array_reserve(items, capacity, count, size)
               ? GRAZE_OK
               : context_fail(context, GRAZE_ESYSTEM, "out of memory for %s", what);
}

int array_compare_numbers(const void *left, const void *right) {
    const size_t *a = left, *b = right;
    return *a < *b ? -1 : *a > *b;
}

size_t array_sort_once(void *items, size_t count, size_t size, array_order *order) {
    char *at = items;
    size_t kept = count > 0;
    if (count)
        qsort(items, count, size, order);
    for (size_t k = 1; k < count; k++)
        if (order(at + (kept - 1) * size, at + k * size) != 0)
            memmove(at + kept++ * size, at + k * size, size);
    return kept;
}

size_t array_first(const void *key, const void *items, size_t count, size_t size,
                   array_order *order) {
    size_t low = 0, high = count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (order((const char *)items + middle * size, key) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

graze_status numbers_add(numbers *list, graze_context *context, size_t number, const char *what) {
    graze_status status = LIST_GROW(context, list, what);
    if (!status)
        list->item[list->count++] = number;
    return status;
}

void numbers_clear(numbers *list) {
    free(list->item);
    *list = (numbers){0};
}

void numbers_sort(numbers *list) {
    list->count =
        array_sort_once(list->item, list->count, sizeof *list->item, array_compare_numbers);
}
