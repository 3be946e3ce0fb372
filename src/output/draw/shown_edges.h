/* The edges of a solid that a picture shows: those at which it bends, of a dense mesh by more than
 * 30 degrees. Coplanar triangles are one face.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_SHOWN_EDGES_H
#define GRAZE_DRAW_SHOWN_EDGES_H

#include "input/solid/solid.h"

/** An edge between two vertices of the input; side `side` of a simplex. */
typedef struct shown_edge {
    uint32_t from, to, simplex;
    unsigned char side, diagonal;
} shown_edge;

typedef struct edge_list {
    shown_edge *item; /* malloc'ed; each edge once */
    size_t count;
    unsigned char *sides; /* a byte for each simplex: bit k is set where side k is shown */
    uint32_t *face; /* of each simplex: the least one of the coplanar ones that it belongs to */
} edge_list;

/** Choose the edges of a solid of E^3. Cleared by edges_clear, also on failure. */
graze_status edges_make(edge_list *out, graze_context *context, const graze_solid *solid);
void edges_clear(edge_list *e);

#endif
