/* Edges of the facets of a flat solid. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Pieces of one line and one facet are joined where boxes have cut them, and are cut where any
 * facet along the line ends, so that facets have the edge in common.
 */
#ifndef GRAZE_INPUT_PLANAR_FLAT_EDGES_H
#define GRAZE_INPUT_PLANAR_FLAT_EDGES_H

#include <flint/fmpq.h>
#include <stdint.h>
#include "base/context/array.h"
#include "input/planar/walk.h"

/** An edge of a facet, which is on its left, seen from outside. */
typedef struct flat_edge {
    size_t plane;
    int facing;
    size_t from, to; /* vertices */
} flat_edge;

/** All edges, sorted by plane, facing and `from`. */
typedef struct flat_edges {
    size_t count, capacity;
    flat_edge *item;
} flat_edges;

/** The ends of edges, each vertex once, in the order of their coordinates. */
typedef struct flat_points {
    int dimension;
    size_t count, capacity;
    fmpq *at;        /* 3 each, as they are found */
    size_t *number;  /* of the vertex at each */
    size_t vertices; /* how many there are */
    size_t *first;   /* of the points at each vertex */
} flat_points;

void flat_points_clear(flat_points *p);

/** Find the edges and the vertices; both are zero at first and cleared by the caller, also after a
 * failure. The pieces are sorted. */
graze_status flat_edges_find(flat_edges *out, flat_points *points, flat_walk *w);
void flat_edges_clear(flat_edges *e);

/** The end of the edges of one plane and facing that begin at `begin`. */
size_t flat_facet_end(const flat_edges *edges, size_t begin);

/** Order edges by `from`. */
int flat_from_order(const void *left, const void *right);

/** Edges [begin, end) of one plane and facing as closed paths without a vertex that stands twice in
 * one. */
typedef struct flat_paths {
    numbers vertex; /* of all paths */
    numbers size;
} flat_paths;

void flat_paths_clear(flat_paths *p);

/** Append the paths of some edges.
 * @param place as long as there are vertices; all are 0, and are so again afterwards */
graze_status flat_paths_find(flat_paths *out, graze_context *context, const flat_edge *edges,
                             size_t count, size_t *place);

#endif
