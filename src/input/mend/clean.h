/* Equal vertices and facets without area.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MEND_CLEAN_H
#define GRAZE_MEND_CLEAN_H

#include "input/mend/mesh.h"

/** Let facets name the first vertex at each position. */
graze_status clean_vertices(mesh *m);
/** Take away corners that repeat the one before them, and facets all of whose corners lie on one
 * line: the boundary has the same points without them. */
graze_status clean_facets(mesh *m);

#endif
