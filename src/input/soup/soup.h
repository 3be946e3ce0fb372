/* soup: the boundary as a file or arrays give it: polygons, indices checked, geometry not yet.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_SOUP_H
#define GRAZE_INPUT_SOUP_H

#include <flint/fmpq.h>
#include <stdint.h>
#include "base/context/context.h"
#include "graze/core.h"

#ifdef __cplusplus
extern "C" {
#endif

/* In E^3 a facet is one or more cycles of vertices (an outer one, then holes; only .nef3 has more
 * than one), outward oriented: seen from outside the outer cycle runs counter-clockwise. In E^2 a
 * facet is one polygon: its cycles are rings, the outer one counter-clockwise, the holes clockwise
 * (the WKT reader turns them so). A cycle does not repeat its first vertex at its end. */

typedef struct soup {
    int dimension;
    size_t vertex_count;
    fmpq *coordinates; /* vertex_count * dimension, canonical */
    size_t index_count;
    uint32_t *index; /* vertex numbers of all cycles */
    size_t cycle_count;
    uint32_t *cycle_start; /* cycle_count + 1 offsets into index */
    size_t facet_count;
    uint32_t *facet_start;    /* facet_count + 1 offsets into cycles */
    unsigned char sha256[32]; /* of the file's bytes; zero for arrays */
    size_t coordinate_capacity, index_capacity, cycle_capacity, facet_capacity;
} soup;

/** An empty soup; it grows by the functions below, which end with GRAZE_ELIMIT past what 32 bits
 * can number. Vertices and facets obey the cells limit. */
void soup_init(soup *s, int dimension);
void soup_clear(soup *s);
/** Append a vertex; `coordinates` are `dimension` canonical rationals, copied. */
graze_status soup_add_vertex(soup *s, graze_context *context, const fmpq *coordinates);
/** Append a facet without cycles, and to the last facet a cycle of vertices, whose numbers the
 * caller has checked. */
graze_status soup_add_facet(soup *s, graze_context *context);
graze_status soup_add_cycle(soup *s, graze_context *context, const size_t *vertex, size_t count);
/** Append a vertex number to the last cycle, which soup_add_cycle may have begun with none. */
graze_status soup_add_index(soup *s, graze_context *context, size_t vertex);

/* The input's names of boundary cells where a facet has several vertices at one position.
 *
 * A simplex has one vertex at each corner, even where several vertices of its facet share the
 * position, so the vertex or edge it gives (solid_cell) may be one name of several, or none of the
 * input's. */

/**
 * The input's name of the cell that simplices call key[k] is name[k]. Sorted by key, then by name,
 * each pair once; a cell that is no key has its own name only.
 */
typedef struct cell_names {
    size_t count;
    graze_cell *key, *name; /* malloc'ed, one block each; NULL where count is 0 */
} cell_names;

/** The order of cells in reports: faces, edges, vertices, each by number. As qsort takes it. */
int cell_compare(const void *a, const void *b);

/** The input's names of a cell that a simplex gave, sorted; borrowed from the table or from the
 * argument. */
const graze_cell *cell_names_of(size_t *count, const cell_names *table, const graze_cell *cell);

void cell_names_clear(cell_names *table);

#ifdef __cplusplus
}
#endif
#endif
