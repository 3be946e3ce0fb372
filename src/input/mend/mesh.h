/* The steps by which a soup becomes a legal solid.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_MEND_MESH_H
#define GRAZE_INPUT_MEND_MESH_H

#include "base/context/array.h"
#include "input/mend/mend.h"

/* A mesh that is being mended: the facets of a soup, which change, and its vertices, which stay. */

/** Facets without their vertices, each one cycle, and of each its number in the input. All members
 * are zero at first. */
typedef struct facets {
    soup of;
    numbers origin;
} facets;

typedef struct mesh {
    graze_context *context; /* borrowed */
    const soup *input;      /* borrowed; E^3, one cycle a facet */
    facets now;
    text report; /* a line for each thing that was done */
} mesh;

/** Copy the facets of a soup, which the mesh borrows. The caller calls mesh_clear, also on failure.
 */
graze_status mesh_init(mesh *m, graze_context *context, const soup *input);
void mesh_clear(mesh *m);

/** Add an empty facet behind the others. */
graze_status facets_begin(facets *f, graze_context *context, size_t origin);
/** Take the last facet away. */
void facets_drop_last(facets *f);
void facets_clear(facets *f);
/** Exchange the mesh's facets with others. */
void mesh_replace(mesh *m, facets *f);

/** Three coordinates of a vertex. */
const fmpq *mesh_point(const mesh *m, uint32_t vertex);
/** Do three points lie on one line? */
int mesh_collinear(const mesh *m, uint32_t a, uint32_t b, uint32_t c);

/** A side of a facet, by the vertices at its ends, low < high. `ascends`: the facet's cycle runs
 * from low to high. */
typedef struct mesh_side {
    uint32_t low, high;
    size_t facet, corner; /* the corner at which the side begins, counted over all facets */
    int ascends;
} mesh_side;

/** List the sides of all facets, sorted by their ends, so that sides of one edge are together. The
 * caller frees `*out`, also on failure. */
graze_status mesh_sides(mesh_side **out, size_t *count, const mesh *m);
/** The number after the last side that belongs to the same edge as side `first`. */
size_t mesh_edge_end(const mesh_side *side, size_t count, size_t first);

/** Make a soup of the facets of one component, with the vertices that they use.
 * @param component of each facet its component; the facets of component `wanted` are taken; NULL:
 * all facets
 * @param turned of each facet whether its cycle is to be reversed; NULL: none is */
graze_status mesh_soup(soup *out, const mesh *m, const size_t *component, size_t wanted,
                       const unsigned char *turned);

/** A list for a line of the report: how many there are, and the first few. */
typedef struct few {
    size_t count;
    text names;
} few;

/** Count one thing; the first few are named, in the format of printf. */
void few_add(few *f, const char *format, ...) __attribute__((format(printf, 2, 3)));
/** Add the line `WHAT N THINGS: first, second, ...` if there are any, and clear. */
void few_report(few *f, mesh *m, const char *what, const char *things);

/* Equal vertices and facets without area. */

/** Replace each vertex in facets by the first vertex at the same position. */
graze_status clean_vertices(mesh *m);
/** Take away corners that repeat the one before them, and facets all of whose corners lie on one
 * line: the boundary has the same points without them. */
graze_status clean_facets(mesh *m);

/* Orientation of facets. */

/** Turn facets round so that two facets that alone share an edge run along it in opposite senses,
 * and shells face outward, or inward if they lie inside an odd number of other shells. A shell that
 * is no legal boundary by itself is left as it is.
 * @param flags GRAZE_SOLID_TRIANGULATE
 * @return GRAZE_EILLEGAL the facets of a shell cannot be oriented, or there are too many shells
 */
graze_status orient_facets(mesh *m, unsigned flags);

/* T-junctions. */

/** An edge that belongs to an odd number of facets is open. Split each open edge at those ends of
 * other open edges that lie strictly inside it. Facets keep their points. */
graze_status split_edges(mesh *m);

/** The ends of all edges that belong to an odd number of facets, each once. The caller frees
 * `*out`, also on failure. */
graze_status split_open_ends(uint32_t **out, size_t *count, mesh *m);

/* Vertices that are one within a distance. */

/** Replace vertices in facets, in the order of their numbers: a vertex within `distance`, a
 * positive number, of earlier vertices that stay is replaced by the nearest of these; all others
 * stay. The report has the largest displacement, rounded up, at most `distance`. */
graze_status weld_vertices(mesh *m, const fmpq_t distance);

/** Add a line with a weld distance that may close the surface, if edges are left open and each end
 * of them is near another end, compared with the extent of all ends. The distance is found in
 * doubles. */
graze_status weld_advise(mesh *m);

#endif
