/* Triangles of any soup, and the edges at which they do not close.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_LOOSE_H
#define GRAZE_VALIDATE_LOOSE_H

#include "input/soup/soup.h"
#include "input/validate/simplices.h"

#ifdef __cplusplus
extern "C" {
#endif

/** An edge, by the input's vertices, and how often triangles run through it each way. */
typedef struct loose_edge {
    uint32_t from, to; /* `forward` is at least `backward` */
    size_t forward, backward;
} loose_edge;

/** Edges that are kept, at most. */
enum { LOOSE_EDGES_KEPT = 8 };

/**
 * Edges that do not close, and among them those with an odd number of triangles. Positions count,
 * not vertex numbers, and points of edges, not their ends: where one edge lies on two others that
 * meet in its middle they close (proofs/mesh.md C114). Whole edges that close are not counted among
 * what passes a part of a line.
 */
typedef struct loose_edges {
    size_t odd_count, unbalanced_count;
    size_t
        kept_count; /* the first by numbers: of the odd ones if there are any, else of the others */
    loose_edge kept[LOOSE_EDGES_KEPT];
} loose_edges;

/**
 * Cut the facets of a soup in E^3 into triangles. They may cross, overlap and be open; those
 * without area are left out, which changes the sums along no edge. Components are joined by whole
 * edges.
 * @param[out] flat_count facets without area, and such triangles of fans
 * @param flags GRAZE_SOLID_TRIANGULATE
 * @return GRAZE_EILLEGAL a facet is not planar or not simple; GRAZE_ELIMIT; GRAZE_ECANCELED;
 * GRAZE_ESYSTEM; GRAZE_EINTERNAL
 */
graze_status validate_loose(simplices *out, loose_edges *edges, size_t *flat_count,
                            graze_context *context, const soup *s, unsigned flags);

#ifdef __cplusplus
}
#endif
#endif
