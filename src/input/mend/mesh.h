/* A mesh that is being mended: the facets of a soup, which change, and its vertices, which stay.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MEND_MESH_H
#define GRAZE_MEND_MESH_H

#include "base/number/text.h"
#include "input/soup/soup.h"

/** Facets, each one cycle of vertices. Zeroed: none. */
typedef struct facets {
    uint32_t *corner; /* of all facets */
    size_t corner_count, corner_capacity;
    size_t *start; /* count + 1 offsets into corner; NULL while there is none */
    size_t count, start_capacity;
    size_t *origin; /* the number of each in the input */
    size_t origin_capacity;
} facets;

typedef struct mesh {
    graze_context *context; /* borrowed */
    const soup *input;      /* borrowed; E^3, one cycle a facet */
    facets now;
    text report; /* a line for each thing that was done */
} mesh;

/** Take the facets of a soup; mesh_clear in any case. */
graze_status mesh_init(mesh *m, graze_context *context, const soup *input);
void mesh_clear(mesh *m);

/** Add an empty facet behind the others. */
graze_status facets_begin(facets *f, graze_context *context, size_t origin);
/** Add a corner to the last one. */
graze_status facets_corner(facets *f, graze_context *context, uint32_t vertex);
/** Take the last facet away. */
void facets_drop_last(facets *f);
void facets_clear(facets *f);
/** Put other facets in place of the mesh's; they are taken over. */
void mesh_replace(mesh *m, facets *f);

/** Three coordinates of a vertex. */
const fmpq *mesh_point(const mesh *m, uint32_t vertex);
/** Do three points lie on one line? */
int mesh_collinear(const mesh *m, uint32_t a, uint32_t b, uint32_t c);

/** A side of a facet, by its ends: low < high; it runs from low to high if it ascends. */
typedef struct mesh_side {
    uint32_t low, high;
    size_t facet, corner; /* the corner it begins at, counted over all facets */
    int ascends;
} mesh_side;

/** The sides of all facets, malloc'ed, those of one edge together, by their ends. */
graze_status mesh_sides(mesh_side **out, size_t *count, const mesh *m);
/** The end of the sides that belong to the edge of side `first`. */
size_t mesh_edge_end(const mesh_side *side, size_t count, size_t first);

/** A soup of the facets of one component, or of all where `component` is NULL, with the vertices
 * they use; `turned` says which are to run the other way round, NULL: none.
 * @param component the component of each facet; facets of `wanted` are taken */
graze_status mesh_soup(soup *out, const mesh *m, const size_t *component, size_t wanted,
                       const unsigned char *turned);

/** A list for a line of the report: how many there are, and the first few. */
typedef struct few {
    size_t count;
    text names;
} few;

/** Add one, named as printf does. */
void few_add(few *f, const char *format, ...) __attribute__((format(printf, 2, 3)));
/** Add the line `WHAT N THINGS: first, second, ...` if there are any, and clear. */
void few_report(few *f, mesh *m, const char *what, const char *things);

#endif
