/* soup: the polygons of a boundary from a file or arrays; their indices are checked, their geometry
 * is not.
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

/** An empty soup; it grows by the functions below. They return GRAZE_ELIMIT if an index exceeds 32
 * bits, or if vertices or facets exceed the limit `cells`. */
void soup_init(soup *s, int dimension);
void soup_clear(soup *s);
/** Append a vertex; `coordinates` are `dimension` canonical rationals, copied. */
graze_status soup_add_vertex(soup *s, graze_context *context, const fmpq *coordinates);
/** soup_add_facet appends a facet without cycles. soup_add_cycle appends a cycle to the last facet;
 * the caller has checked the numbers of its vertices. */
graze_status soup_add_facet(soup *s, graze_context *context);
graze_status soup_add_cycle(soup *s, graze_context *context, const size_t *vertex, size_t count);
/** Append a vertex number to the last cycle, which soup_add_cycle may have begun with none. */
graze_status soup_add_index(soup *s, graze_context *context, size_t vertex);

/* The input's names of boundary cells where a facet has several vertices at one position.
 *
 * A simplex has one vertex at each corner, even where several vertices of its facet share the
 * position, so the vertex or edge of the simplex (solid_cell) may have several names in the input,
 * or none. */

/**
 * The cell that simplices call key[k] has the name name[k] in the input. Sorted by key, then by
 * name, each pair once; a cell that is no key has one name, itself.
 */
typedef struct cell_names {
    size_t count;
    graze_cell *key, *name; /* malloc'ed, one block each; NULL where count is 0 */
} cell_names;

/** The order of cells in reports: faces, edges, vertices, each by number. A comparison function for
 * qsort. */
int cell_compare(const void *a, const void *b);

/** The input's names of a cell that a simplex gave, sorted; borrowed from the table or from the
 * argument. */
const graze_cell *cell_names_of(size_t *count, const cell_names *table, const graze_cell *cell);

void cell_names_clear(cell_names *table);

#ifdef __cplusplus
}
#endif
#endif
