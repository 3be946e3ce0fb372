/* The boundary of a solid as simplices, which the validation makes of a soup.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_SIMPLICES_H
#define GRAZE_VALIDATE_SIMPLICES_H

#include <stddef.h>
#include <stdint.h>
#include "input/soup/cell_names.h"

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
                           among those that have a length */
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

#ifdef __cplusplus
}
#endif
#endif
