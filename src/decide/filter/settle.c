/* Windows of time that touch are united, and crossings that touch a window or another crossing are
 * taken into windows, until no two of them touch.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <math.h>
#include <stdlib.h>
#include "base/context/array.h"
#include "decide/filter/search.h"

static int compare_by_time(const void *left, const void *right) {
    const candidate *a = left, *b = right;
    if (a->piece != b->piece)
        return a->piece < b->piece ? -1 : 1;
    if (a->from != b->from)
        return a->from < b->from ? -1 : 1;
    return a->to < b->to ? -1 : a->to > b->to;
}

static int compare_crossings(const void *left, const void *right) {
    const crossing *a = left, *b = right;
    if (a->piece != b->piece)
        return a->piece < b->piece ? -1 : 1;
    return a->from < b->from ? -1 : a->from > b->from;
}

/* Make exact windows of the candidates: windows that have a time in common become one. */
static int unite_windows(findings *found) {
    found->window_count = 0;
    if (found->asked.count)
        qsort(found->asked.item, found->asked.count, sizeof *found->asked.item, compare_by_time);
    for (size_t k = 0; k < found->asked.count; k++) {
        const candidate *next = &found->asked.item[k];
        exact_window *last = found->window_count ? &found->window[found->window_count - 1] : NULL;
        if (last && last->piece == next->piece && !flip(FLIP_APART, next->from > last->to)) {
            last->to = next->to > last->to ? next->to : last->to;
            last->count++;
        } else if (!findings_add_window(found,
                                        (exact_window){next->piece, next->from, next->to, k, 1})) {
            return 0;
        }
    }
    return 1;
}

static const double UNITS = (double)(UINT32_C(1) << WINDOW_LEVELS);

/* Does a crossing touch a window? `first`: the first window of the crossing's piece. */
static int meets_window(const findings *found, size_t first, const crossing *c) {
    for (size_t k = first; k < found->window_count && found->window[k].piece == c->piece; k++)
        if (!flip(FLIP_APART,
                  c->from * UNITS > found->window[k].to || c->to * UNITS < found->window[k].from))
            return 1;
    return 0;
}

static int meets_crossing(const crossing *c, const crossing *other) {
    return c->piece == other->piece && !flip(FLIP_APART, other->from > c->to);
}

static int ask_for_crossing(findings *found, const crossing *c) {
    candidate asked = {c->piece, c->simplex, (uint32_t)floor(fmax(0, c->from * UNITS)),
                       (uint32_t)ceil(fmin(UNITS, c->to * UNITS))};
    return candidates_append(&found->asked, asked);
}

/* Make candidates of the crossings that are not certainly apart, in time, from all windows and
 * other crossings; 1 if there was one, -1 if memory runs out. */
static int ask_for_meeting(findings *found) {
    size_t kept = 0, n = found->crossing_count, window = 0;
    crossing *c = found->crossing,
             latest = {.to = -INFINITY}; /* the one that ends latest, so far */
    int moved = 0;
    for (size_t k = 0; k < n; k++) {
        crossing here = c[k];
        while (window < found->window_count && found->window[window].piece < here.piece)
            window++;
        int meets = meets_window(found, window, &here) ||
                    (k > 0 && meets_crossing(&latest, &here)) ||
                    (k + 1 < n && meets_crossing(&here, &c[k + 1]));
        if (k == 0 || latest.piece != here.piece || here.to > latest.to)
            latest = here;
        if (!meets) {
            c[kept++] = here;
            continue;
        }
        if (!ask_for_crossing(found, &here))
            return -1;
        moved = 1;
    }
    found->crossing_count = kept;
    return moved;
}

static int compare_pieces(const void *left, const void *right) {
    const uint32_t *a = left, *b = right;
    return *a < *b ? -1 : *a > *b;
}

static int is_lost(const findings *found, uint32_t piece) {
    return bsearch(&piece, found->lost, found->lost_count, sizeof *found->lost, compare_pieces) !=
           NULL;
}

/* Order the lost pieces, each once, and drop the crossings and candidates in them. */
static void drop_lost(findings *found) {
    size_t kept = 0;
    if (!found->lost_count)
        return;
    found->lost_count =
        array_sort_once(found->lost, found->lost_count, sizeof *found->lost, compare_pieces);
    for (size_t k = 0; k < found->crossing_count; k++)
        if (!is_lost(found, found->crossing[k].piece))
            found->crossing[kept++] = found->crossing[k];
    found->crossing_count = kept;
    kept = 0;
    for (size_t k = 0; k < found->asked.count; k++)
        if (!is_lost(found, found->asked.item[k].piece))
            found->asked.item[kept++] = found->asked.item[k];
    found->asked.count = kept;
}

int findings_settle(findings *found) {
    drop_lost(found);
    if (found->crossing_count)
        qsort(found->crossing, found->crossing_count, sizeof *found->crossing, compare_crossings);
    /* A trajectory along a simplex is found in each span, so its windows are joined. */
    candidates_join(&found->asked);
    int moved;
    do {
        if (!unite_windows(found))
            return 0;
        moved = ask_for_meeting(found);
    } while (moved > 0);
    return moved == 0;
}
