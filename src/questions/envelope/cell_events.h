/* Moments that concern a cell (proofs/events.md C84).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_CELL_EVENTS_H
#define GRAZE_ENVELOPE_CELL_EVENTS_H

#include "questions/envelope/moments.h"

/** An event of one cell or of two at a moment. */
typedef struct cell_event {
    graze_cell first, second;
    size_t moment;
} cell_event;

/** In the order of cells, then of moments. */
typedef struct cell_event_list {
    size_t count;
    cell_event *item;
} cell_event_list;

/** Moments ascending, each once. */
typedef struct moment_cuts {
    size_t count, capacity, *item;
} moment_cuts;

/** @param[out] out uninitialised; cell_events_clear in any case */
graze_status cell_events_make(cell_event_list *out, graze_context *context, const graze_envelope *e,
                              const moment_list *moments);
void cell_events_clear(cell_event_list *list);

/** Empty a list and put the hard moments there. */
graze_status cuts_start(moment_cuts *cuts, graze_context *context, const moment_list *moments);
graze_status cuts_add(moment_cuts *cuts, graze_context *context, size_t moment);
/** Put the list in order once all are there. */
void cuts_sort(moment_cuts *cuts);

/** Add the moments that concern a cell. */
graze_status cuts_add_of_facet(moment_cuts *cuts, graze_context *context,
                               const cell_event_list *list, const cell_complex *c, size_t facet);
graze_status cuts_add_of_edge(moment_cuts *cuts, graze_context *context,
                              const cell_event_list *list, const cell_complex *c, size_t edge);
graze_status cuts_add_of_vertex(moment_cuts *cuts, graze_context *context,
                                const cell_event_list *list, const cell_complex *c, size_t vertex);

#endif
