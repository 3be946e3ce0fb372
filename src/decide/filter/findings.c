/* Lists of crossings, candidates and windows, which grow.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <math.h>
#include <stdlib.h>
#include "base/context/array.h"
#include "decide/filter/search.h"

candidate candidate_in(time_part part, uint32_t simplex, const meet_window *w) {
    double length = (double)(UINT32_C(1) << (WINDOW_LEVELS - part.level));
    double from = fmax(0, floor(w->low * length) - 1 + part.start);
    double to =
        fmin((double)(UINT32_C(1) << WINDOW_LEVELS), ceil(w->high * length) + 1 + part.start);
    return (candidate){part.piece, simplex, (uint32_t)from, (uint32_t)to};
}

/* The start is a multiple of 2^-24, so only the product and the sum are rounded: by less than 2^-52
 * together. */
crossing crossing_in(time_part part, uint32_t simplex, const meet_window *w) {
    double start = ldexp(part.start, -WINDOW_LEVELS);
    return (crossing){start + ldexp(w->low, -part.level) - 0x1p-51,
                      start + ldexp(w->high, -part.level) + 0x1p-51, part.piece, simplex,
                      w->enters};
}

int candidates_append(candidates *list, candidate item) {
    if (!array_reserve(&list->item, &list->capacity, list->count + 1, sizeof *list->item))
        return 0;
    list->item[list->count++] = item;
    return 1;
}

static int compare_candidates(const void *left, const void *right) {
    const candidate *a = left, *b = right;
    if (a->piece != b->piece)
        return a->piece < b->piece ? -1 : 1;
    if (a->simplex != b->simplex)
        return a->simplex < b->simplex ? -1 : 1;
    return a->from < b->from ? -1 : a->from > b->from;
}

void candidates_join(candidates *list) {
    size_t kept = 0;
    if (list->count)
        qsort(list->item, list->count, sizeof *list->item, compare_candidates);
    for (size_t k = 0; k < list->count; k++) {
        const candidate *next = &list->item[k];
        candidate *last = kept ? &list->item[kept - 1] : NULL;
        if (last && last->piece == next->piece && last->simplex == next->simplex &&
            next->from <= last->to)
            last->to = next->to > last->to ? next->to : last->to;
        else
            list->item[kept++] = *next;
    }
    list->count = kept;
}

int findings_add_crossing(findings *found, crossing item) {
    if (!array_reserve(&found->crossing, &found->crossing_capacity, found->crossing_count + 1,
                       sizeof *found->crossing))
        return 0;
    found->crossing[found->crossing_count++] = item;
    return 1;
}

int findings_add_window(findings *found, exact_window item) {
    if (!array_reserve(&found->window, &found->window_capacity, found->window_count + 1,
                       sizeof *found->window))
        return 0;
    found->window[found->window_count++] = item;
    return 1;
}

int findings_lose(findings *found, uint32_t piece) {
    if (found->lost_count && found->lost[found->lost_count - 1] == piece)
        return 1;
    if (!array_reserve(&found->lost, &found->lost_capacity, found->lost_count + 1,
                       sizeof *found->lost))
        return 0;
    found->lost[found->lost_count++] = piece;
    return 1;
}

void findings_clear(findings *found) {
    free(found->crossing);
    free(found->asked.item);
    free(found->window);
    free(found->lost);
    *found = (findings){.crossing_count = 0};
}
