/* From the findings of a search to disjoint windows: what is not certainly apart is asked together.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "filter/filter.h"

#include <math.h>
#include <stdlib.h>
#include "filter/flip.h"
#include "filter/search.h"

graze_status filter_make(filter *out, graze_context *context, const graze_solid *solid,
                         const graze_motion *motion, graze_operation operation) {
    *out = (filter){.solid = solid};
    out->piece = calloc(motion->piece_count, sizeof *out->piece);
    for (size_t k = 0; out->piece && k < motion->piece_count; k++) {
        const motion_piece *piece = &motion->piece[k];
        out->piece_count = k + 1;
        if (!carrier_make(&out->piece[k], motion_tracing(piece, operation))) {
            filter_clear(out);
            break;
        }
    }
    return out->piece
               ? GRAZE_OK
               : context_fail(context, GRAZE_ESYSTEM, "out of memory for the filter of %zu pieces",
                              motion->piece_count);
}

void filter_clear(filter *f) {
    for (size_t k = 0; k < f->piece_count; k++)
        carrier_clear(&f->piece[k]);
    free(f->piece);
    *f = (filter){.solid = NULL};
}

static void workspace_free(void *memory) {
    filter_workspace *w = memory;
    curve_clear(&w->curve);
    curve_clear(&w->ray);
    findings_clear(&w->found);
    findings_clear(&w->ray_found);
    free(w);
}

filter_workspace *filter_workspace_of(graze_context *context) {
    if (!context->workspace) {
        context->workspace = calloc(1, sizeof(filter_workspace));
        context->workspace_free = workspace_free;
    }
    return context->workspace;
}

static int compare_by_time(const void *left, const void *right) {
    const candidate *a = left, *b = right;
    if (a->from != b->from)
        return a->from < b->from ? -1 : 1;
    return a->to < b->to ? -1 : a->to > b->to;
}

static int compare_crossings(const void *left, const void *right) {
    const crossing *a = left, *b = right;
    return a->from < b->from ? -1 : a->from > b->from;
}

/* Windows that have a point in common become one. */
static int unite_windows(findings *found) {
    found->window_count = 0;
    if (found->asked.count)
        qsort(found->asked.item, found->asked.count, sizeof *found->asked.item, compare_by_time);
    for (size_t k = 0; k < found->asked.count; k++) {
        const candidate *next = &found->asked.item[k];
        exact_window *last = found->window_count ? &found->window[found->window_count - 1] : NULL;
        if (last && !flip(FLIP_APART, next->from > last->to)) {
            last->to = next->to > last->to ? next->to : last->to;
            last->count++;
        } else if (!findings_add_window(found, (exact_window){next->from, next->to, k, 1})) {
            return 0;
        }
    }
    return 1;
}

static const double UNITS = (double)(UINT32_C(1) << WINDOW_LEVELS);

static int meets_window(const findings *found, const crossing *c) {
    for (size_t k = 0; k < found->window_count; k++)
        if (!flip(FLIP_APART,
                  c->from * UNITS > found->window[k].to || c->to * UNITS < found->window[k].from))
            return 1;
    return 0;
}

/* A crossing that is not certainly apart from all else becomes a candidate: 1 if there was one, -1
 * without
 * memory. */
static int ask_for_meeting(findings *found) {
    size_t kept = 0, n = found->crossing_count;
    crossing *c = found->crossing;
    double reached = -INFINITY; /* the latest end so far */
    int moved = 0;
    for (size_t k = 0; k < n; k++) {
        int meets = meets_window(found, &c[k]) || !flip(FLIP_APART, c[k].from > reached) ||
                    (k + 1 < n && !flip(FLIP_APART, c[k + 1].from > c[k].to));
        reached = fmax(reached, c[k].to);
        if (!meets) {
            c[kept++] = c[k];
            continue;
        }
        candidate asked = {c[k].simplex, (uint32_t)floor(fmax(0, c[k].from * UNITS)),
                           (uint32_t)ceil(fmin(UNITS, c[k].to * UNITS))};
        if (!candidates_append(&found->asked, asked))
            return -1;
        moved = 1;
    }
    found->crossing_count = kept;
    return moved;
}

void filter_begin(filter_workspace *w) {
    w->piece = SIZE_MAX;
}

int filter_set(filter_workspace *w, const filter *f, size_t piece, const filter_point *point) {
    const corners *corners = &f->solid->corners;
    if (w->piece == piece)
        return 1;
    w->piece = SIZE_MAX;
    if (!corners->at || !curve_set(&w->curve, &f->piece[piece], point, corners))
        return 0;
    w->piece = piece;
    return 1;
}

int filter_search(filter_workspace *w, const filter *f, size_t piece, const filter_point *point) {
    findings *found = &w->found;
    if (!filter_set(w, f, piece, point) || !search_curve(found, &w->curve, f->solid))
        return 0;
    if (found->crossing_count)
        qsort(found->crossing, found->crossing_count, sizeof *found->crossing, compare_crossings);
    int moved;
    do {
        if (!unite_windows(found))
            return 0;
        moved = ask_for_meeting(found);
    } while (moved > 0);
    return moved == 0;
}
