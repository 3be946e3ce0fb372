/* The geometry a soup must have to bound a solid, decided exactly, and its cut into simplices. CGAL
 * is used behind this header, crossing.h and overlap.h only.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_VALIDATE_H
#define GRAZE_VALIDATE_VALIDATE_H

#include "input/soup/soup.h"
#include "input/validate/simplices.h"

#ifdef __cplusplus
extern "C" {
#endif

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
