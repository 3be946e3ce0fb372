/* Lists of crossings, candidates and windows, which grow.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "filter/findings.h"

#include <stdlib.h>

int candidates_append(candidates *list, candidate item) {
    if (list->count == list->capacity) {
        size_t capacity = list->capacity ? 2 * list->capacity : 32;
        candidate *items = realloc(list->item, capacity * sizeof *items);
        if (!items)
            return 0;
        list->item = items;
        list->capacity = capacity;
    }
    list->item[list->count++] = item;
    return 1;
}

int findings_add_crossing(findings *found, crossing item) {
    if (found->crossing_count == found->crossing_capacity) {
        size_t capacity = found->crossing_capacity ? 2 * found->crossing_capacity : 16;
        crossing *items = realloc(found->crossing, capacity * sizeof *items);
        if (!items)
            return 0;
        found->crossing = items;
        found->crossing_capacity = capacity;
    }
    found->crossing[found->crossing_count++] = item;
    return 1;
}

int findings_add_window(findings *found, exact_window item) {
    if (found->window_count == found->window_capacity) {
        size_t capacity = found->window_capacity ? 2 * found->window_capacity : 16;
        exact_window *items = realloc(found->window, capacity * sizeof *items);
        if (!items)
            return 0;
        found->window = items;
        found->window_capacity = capacity;
    }
    found->window[found->window_count++] = item;
    return 1;
}

void findings_clear(findings *found) {
    free(found->crossing);
    free(found->asked.item);
    free(found->window);
    *found = (findings){.crossing_count = 0};
}
