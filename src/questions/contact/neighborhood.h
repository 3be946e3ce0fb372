/* A boundary point of a solid: the facets that contain it, by position, and what the solid is like
 * near it. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTACT_NEIGHBORHOOD_H
#define GRAZE_CONTACT_NEIGHBORHOOD_H

#include "input/solid/solid.h"

/** The local cone (proofs/envelope.md C57): a half-space, convex, with a convex complement, or
 * neither of these. */
typedef enum place_kind { PLACE_FACET, PLACE_CONVEX, PLACE_REFLEX, PLACE_OTHER } place_kind;

/** A facet that contains the point; one that is not planar counts once for each of its planes. */
typedef struct place_facet {
    graze_cell name; /* a face; in E^2 an edge */
    size_t simplex;  /* one in the facet and its plane that contains the point */
    fmpz form[4];    /* the plane's form, positive on the outer side: d + 1 coprime integers */
    fmpz normal[3];  /* its first d coefficients, coprime */
} place_facet;

/** `cell` is the lowest cell that contains the point, of these the one of the least numbers. */
typedef struct neighborhood {
    int dimension;
    place_kind kind;
    graze_cell cell;
    size_t count, capacity;
    place_facet *facet; /* in the order of names */
} neighborhood;

/** Find the place of a point of d rationals. `count` is 0 if it is not on the boundary.
 * @param[out] out uninitialised; place_clear in any case */
graze_status neighborhood_locate(neighborhood *out, graze_context *context,
                                 const graze_solid *solid, const fmpq *point);
void neighborhood_clear(neighborhood *p);

#endif
