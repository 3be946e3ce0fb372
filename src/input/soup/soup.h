/* A polygon soup: the boundary as a file or the caller's arrays give it, indices checked, geometry
 * not yet. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * In E^3 a facet is one or more cycles of vertices (an outer one, then holes; only .nef3 has more
 * than one), outward oriented: seen from outside the outer cycle runs counter-clockwise. In E^2 a
 * facet is one polygon: its cycles are rings, the outer one counter-clockwise, the holes clockwise
 * (the WKT reader turns them so). A cycle does not repeat its first vertex at its end.
 */
#ifndef GRAZE_SOUP_SOUP_H
#define GRAZE_SOUP_SOUP_H

#include <flint/fmpq.h>
#include <stdint.h>
#include "base/context/context.h"

#ifdef __cplusplus
extern "C" {
#endif

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

/** An empty soup; grows by the functions below, which obey the cells limit and end with
 * GRAZE_ELIMIT past what 32 bits can number. */
void soup_init(soup *s, int dimension);
void soup_clear(soup *s);
/** Append a vertex; `coordinates` are `dimension` canonical rationals, copied. Obeys the cells
 * limit. */
graze_status soup_add_vertex(soup *s, graze_context *context, const fmpq *coordinates);
/** Append a facet without cycles; its cycles follow. The caller has checked that indices are in
 * range. */
graze_status soup_add_facet(soup *s, graze_context *context);
graze_status soup_add_cycle(soup *s, graze_context *context, const size_t *vertex, size_t count);
/** Append a vertex number to the last cycle, which soup_add_cycle may have begun with none. */
graze_status soup_add_index(soup *s, graze_context *context, size_t vertex);

#ifdef __cplusplus
}
#endif
#endif
