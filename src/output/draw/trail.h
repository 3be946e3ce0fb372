/* The trajectory of a query point, cut at its contacts, as lines of a picture.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * States, contacts and their cells are those of the exact trace; only the places that are drawn
 * are rounded.
 */
#ifndef GRAZE_DRAW_TRAIL_H
#define GRAZE_DRAW_TRAIL_H

#include "decide/trace/trajectory.h"
#include "output/draw/class_grid.h"

/** A stretch of one state: places first ... first + count - 1. Neighbours share a place. */
typedef struct trail_span {
    graze_state state;
    size_t first, count;
} trail_span;

typedef struct trail_contact {
    graze_kind kind;
    graze_cell_kind
        cell;     /* of the smallest dimension at an instant, inside an interval the largest */
    double at[3]; /* of an interval the middle one of its places */
    int lasts;    /* an interval: */
    graze_cell_kind end_cell[2];
    double end[2][3];
} trail_contact;

typedef struct trail {
    tone tone;
    double *at; /* places, three coordinates each */
    size_t place_count, place_capacity;
    trail_span *span;
    size_t span_count;
    trail_contact *contact;
    size_t contact_count;
} trail;

/**
 * Trace a point and follow its trajectory: the inverted one for a sweep, the forward one for an
 * unsweep.
 * @param[out] out cleared by trail_clear, also on failure
 * @param fineness how far from the curve the lines may be
 */
graze_status trail_make(trail *out, graze_context *context, const graze_scene *scene,
                        const fmpq *point, double fineness);
void trail_clear(trail *c);

/** The extent of that part of the curve's image that lies in a rectangle. */
void trail_extent(extent *out, const trail *c, const projection *look, const extent *within);

#endif
