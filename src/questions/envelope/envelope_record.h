/* The envelope: cells, velocity fields, events, finding.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_ENVELOPE_RECORD_H
#define GRAZE_ENVELOPE_ENVELOPE_RECORD_H

#include "decide/scene/scene.h"
#include "questions/envelope/cells.h"
#include "questions/envelope/derivatives.h"
#include "questions/envelope/events.h"

/** The finding that decides whether the envelope decomposes: the one of the least reason, of these
 * the first. */
typedef struct finding {
    graze_decomposable_reason reason;
    graze_cell facet, cell;
    graze_time *time; /* or NULL; owned */
} finding;

/** One field a piece. `is_break`: two different pieces meet at the beginning of piece k. `still`:
 * entry piece * facets + facet: g vanishes all over the facet on the piece. */
struct graze_envelope {
    const graze_scene *scene;
    cell_complex cells;
    size_t piece_count;
    derivatives *field;
    unsigned char *is_break, *still;
    event_list events;
    finding found;
};

/** Where a part ends: at a vertex; or else within an edge, where g of a facet vanishes. Numbers of
 * these, SIZE_MAX for none. */
typedef struct part_end {
    size_t vertex, edge, facet;
} part_end;

/** A part of the curve: `a` and `b` are its ends, d rationals each, the same for a point; of a
 * whole facet a point within it. `number` is that of its facet, edge or vertex. */
typedef struct curve_part {
    graze_curve_part facts;
    fmpq *a, *b;
    size_t number;
    part_end end[2];
} curve_part;

struct graze_curve {
    int dimension;
    fmpq_t t;
    size_t count, capacity;
    curve_part *part;
};

#endif
