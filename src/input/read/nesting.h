/* Polygons from rings of E^2: outer rings and holes, by how the rings lie in one another.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_READ_NESTING_H
#define GRAZE_READ_NESTING_H

#include "input/soup/soup.h"

/**
 * Append rings to a soup of E^2 as polygons: a ring inside an even number of others is an outer one
 * and is turned counter-clockwise, the others are holes of the innermost ring around them and are
 * turned clockwise. Rings that cross get some place; validation refuses them.
 * @param size  ring_count sizes, each at least 3
 * @param index the vertices of all rings, in range of the soup's vertices
 * @return GRAZE_EILLEGAL a ring has area zero, named as facet; GRAZE_ELIMIT; GRAZE_ESYSTEM
 */
graze_status nesting_add_rings(soup *s, graze_context *context, const size_t *size,
                               size_t ring_count, const size_t *index);

#endif
