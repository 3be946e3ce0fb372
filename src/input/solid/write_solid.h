/* A solid as the text of an exact file.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SOLID_WRITE_SOLID_H
#define GRAZE_SOLID_WRITE_SOLID_H

#include "base/number/text.h"
#include "input/solid/solid.h"

/** In E^3 OFF: the vertices by their numbers, and the triangles the facets are cut into, those of a
 * facet together. In E^2 WKT: one MULTIPOLYGON, its rings turned as the soup has them. */
void solid_write(text *out, const graze_solid *solid);

#endif
