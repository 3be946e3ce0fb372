/* The input's names of boundary cells where a facet has several vertices at one position.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A simplex has one vertex at each corner, even where several vertices of its facet share the
 * position, so the vertex or edge it gives (solid_cell) may be one name of several, or none of the
 * input's.
 */
#ifndef GRAZE_SOUP_CELL_NAMES_H
#define GRAZE_SOUP_CELL_NAMES_H

#include "graze/core.h"

#ifdef __cplusplus
extern "C" {
#endif

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
