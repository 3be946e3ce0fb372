/* Moments that concern a cell (proofs/events.md C84).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_CONCERN_H
#define GRAZE_ENVELOPE_CONCERN_H

#include "questions/envelope/moments.h"

/** An event of one cell or of two at a moment. */
typedef struct concern {
    graze_cell first, second;
    size_t moment;
} concern;

/** In the order of cells, then of moments. */
typedef struct concern_list {
    size_t count;
    concern *item;
} concern_list;

/** Moments ascending, each once. */
typedef struct moment_cuts {
    size_t count, capacity, *item;
} moment_cuts;

/** @param[out] out uninitialised; concerns_clear in any case */
graze_status concerns_make(concern_list *out, graze_context *context, const graze_envelope *e,
                           const moment_list *moments);
void concerns_clear(concern_list *list);

/** Empty a list and put the hard moments there. */
graze_status cuts_start(moment_cuts *cuts, graze_context *context, const moment_list *moments);
graze_status cuts_add(moment_cuts *cuts, graze_context *context, size_t moment);
/** Put the list in order once all are there. */
void cuts_sort(moment_cuts *cuts);

/** Add the moments that concern a cell. */
graze_status concern_facet(moment_cuts *cuts, graze_context *context, const concern_list *list,
                           const cell_complex *c, size_t facet);
graze_status concern_edge(moment_cuts *cuts, graze_context *context, const concern_list *list,
                          const cell_complex *c, size_t edge);
graze_status concern_vertex(moment_cuts *cuts, graze_context *context, const concern_list *list,
                            const cell_complex *c, size_t vertex);

#endif
