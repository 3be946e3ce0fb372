/* The geometry a soup must have to bound a solid, decided exactly, and its cut into simplices. CGAL
 * is used behind this header, crossing.h and overlap.h only.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_VALIDATE_H
#define GRAZE_VALIDATE_VALIDATE_H

#include <stdint.h>
#include "soup/names.h"
#include "soup/soup.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * A piece of the boundary: a triangle (d = 3) or a segment (d = 2). Outward oriented: d = 3
 * counter-clockwise seen from outside, d = 2 the solid lies on the left of vertex 0 -> vertex 1.
 * Side k: d = 3 the edge from vertex k to vertex (k+1)%3; d = 2 the vertex k.
 */
typedef struct simplex {
    uint32_t vertex[3]; /* the input's numbers; vertex[2] unused in E^2 */
    uint32_t facet;     /* the input's facet; in E^2 the number of the edge in order of appearance,
                           among     those that have a length */
    uint32_t component; /* edge-connected (E^2: vertex-connected) component of the boundary,
                           numbered from 0 */
    uint8_t diagonal;   /* bit k set: side k is no input edge but was made by cutting the facet */
} simplex;

/** Sides of the input whose ends are one position: no edges. */
typedef struct flat_sides {
    size_t count;
    size_t facet, cycle; /* of the first: its facet (E^2: polygon) and its cycle there */
    uint32_t from, to;   /* its ends */
} flat_sides;

typedef struct simplices {
    size_t count;
    simplex *item; /* malloc'ed; those of one facet stand together */
    size_t component_count;
    cell_names names; /* where simplices do not have all the input's names */
    flat_sides flat;
} simplices;

void simplices_clear(simplices *cut);

/** A flag beside GRAZE_SOLID_TRIANGULATE: this soup has passed before, so the search for facets
 * that meet is left out in E^3, and contacts inside facets join no components. */
#define VALIDATE_TRUST_CONTACTS (1u << 31)

/**
 * Check everything about a soup that is local, and cut its facets. Checked: facets not degenerate,
 * planar and simple; edges run through as often one way as the other (by position); relative
 * interiors of facets disjoint; around every segment (E^2: point) where more than two facet sides
 * meet, in and out alternate. The caller makes one side test per component.
 * @param flags GRAZE_SOLID_TRIANGULATE, VALIDATE_TRUST_CONTACTS
 * @return GRAZE_EILLEGAL naming facets, edges, vertices; GRAZE_ELIMIT; GRAZE_EINTERNAL
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
