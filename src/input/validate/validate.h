/* validate: simplices of a soup that bounds a solid, or the reason why it bounds none, or where
 * any soup does not close; the one room that uses CGAL.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_VALIDATE_H
#define GRAZE_INPUT_VALIDATE_H

#include <stddef.h>
#include <stdint.h>
#include "input/soup/soup.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The boundary of a solid as simplices, which the validation makes of a soup. */

/**
 * A piece of the boundary: a triangle (d = 3) or a segment (d = 2). Outward oriented: d = 3
 * counter-clockwise seen from outside, d = 2 the solid lies on the left of vertex 0 -> vertex 1.
 * Side k: d = 3 the edge from vertex k to vertex (k+1)%3; d = 2 the vertex k.
 */
typedef struct simplex {
    uint32_t vertex[3]; /* the input's numbers; vertex[2] unused in E^2 */
    uint32_t facet;     /* the input's facet; in E^2 the number of the edge in order of appearance,
                           among those that have a length */
    uint32_t component; /* edge-connected (E^2: vertex-connected) component of the boundary,
                           numbered from 0 */
    uint8_t diagonal;   /* bit k set: side k is no input edge but was made by cutting the facet */
} simplex;

/** Sides of the input with both ends at one position, which are no edges. */
typedef struct flat_sides {
    size_t count;
    size_t facet, cycle; /* facet (E^2: polygon) of the first side, and cycle in the facet */
    uint32_t from, to;   /* its ends */
} flat_sides;

typedef struct simplices {
    size_t count;
    simplex *item; /* malloc'ed; those of one facet stand together */
    size_t component_count;
    cell_names names; /* names of cells that the input has and the simplices lack */
    flat_sides flat;
} simplices;

void simplices_clear(simplices *cut);

/* The crossings of a ring of area zero with itself, for the readers' messages. */

/**
 * Name the two edges or the vertex in which a ring of E^2 with area zero crosses itself.
 * @param cycle the ring in the soup, which need not be whole
 * @return GRAZE_EILLEGAL naming the edges; GRAZE_OK if it crosses nowhere, or only in edges that
 * lie on one another; GRAZE_ECANCELED; GRAZE_EINTERNAL
 */
graze_status validate_crossing(graze_context *context, const soup *s, size_t cycle);

/* Triangles of any soup, and the edges at which they do not close. */

/** An edge, by the input's vertices, and how often triangles run through it each way. */
typedef struct loose_edge {
    uint32_t from, to; /* `forward` is at least `backward` */
    size_t forward, backward;
} loose_edge;

/** Edges that are kept, at most. */
enum { LOOSE_EDGES_KEPT = 8 };

/**
 * The number of edges that do not close, and of those among them with an odd number of triangles.
 * Edges are compared by positions, not by vertex numbers, and point by point: an edge and two
 * others that lie on it and meet in its middle close each other (proofs/mesh.md C114). `forward`
 * and `backward` leave out edges that close as a whole.
 */
typedef struct loose_edges {
    size_t odd_count, unbalanced_count;
    /* The first edges by their vertices: odd ones if there are any, else all. */
    size_t kept_count;
    loose_edge kept[LOOSE_EDGES_KEPT];
} loose_edges;

/**
 * Cut the facets of a soup in E^3 into triangles. They may cross, overlap and be open; those
 * without area are left out, which changes no sum along an edge. Components are joined by whole
 * edges.
 * @param[out] flat_count the number of facets without area, and of triangles of fans without area
 * @param flags GRAZE_SOLID_TRIANGULATE
 * @return GRAZE_EILLEGAL a facet is not planar or not simple; GRAZE_ELIMIT; GRAZE_ECANCELED;
 * GRAZE_ESYSTEM; GRAZE_EINTERNAL
 */
graze_status validate_loose(simplices *out, loose_edges *edges, size_t *flat_count,
                            graze_context *context, const soup *s, unsigned flags);

/* The test whether a boundary meets its image under a map. */

/**
 * Does any simplex of S touch any simplex of the image of S under the affine map? Simplices are
 * closed sets; the answer is exact. The caller tests whether one boundary lies inside the other
 * solid.
 * @param map d*(d+1) rationals, row by row, invertible
 */
graze_status boundaries_meet(int *out, graze_context *context, const soup *s, const simplices *cut,
                             const fmpq *map);

/* The geometry a soup must have to bound a solid, decided exactly, and its cut into simplices.
 * CGAL is used in this room alone. */

/** A flag beside GRAZE_SOLID_TRIANGULATE: this soup has passed before, so the search for facets
 * that meet is left out in E^3, and contacts inside facets join no components. */
#define VALIDATE_TRUST_CONTACTS (1u << 31)

/**
 * Check everything about a soup that is local, and cut its facets. Checked: facets not degenerate,
 * planar and simple; edges run through as often one way as the other (by position); relative
 * interiors of facets disjoint; around every segment (E^2: point) where more than two facet sides
 * meet, in and out alternate. The caller makes one side test per component.
 * @param flags GRAZE_SOLID_TRIANGULATE, VALIDATE_TRUST_CONTACTS
 * @return GRAZE_EILLEGAL naming facets, edges, vertices; GRAZE_ELIMIT; GRAZE_ECANCELED;
 * GRAZE_ESYSTEM; GRAZE_EINTERNAL
 */
graze_status validate_soup(simplices *out, graze_context *context, const soup *s, unsigned flags);

/**
 * Fail a precondition of CGAL on purpose, so that a test sees how such a fault arrives.
 * @return GRAZE_EINTERNAL, if all is well
 */
graze_status validate_probe(graze_context *context);

/** The version of CGAL that was compiled in, such as "5.5.1"; static. */
const char *validate_cgal_version(void);

#ifdef __cplusplus
}
#endif
#endif
