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
