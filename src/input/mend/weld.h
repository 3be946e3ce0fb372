/* Vertices that are one within a distance.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MEND_WELD_H
#define GRAZE_MEND_WELD_H

#include "input/mend/mesh.h"

/** Let facets name, in place of a vertex, the nearest one before it that stays, where that is no
 * further than `distance`, a positive number. The report has the largest displacement, rounded up;
 * it is at most `distance`. */
graze_status weld_vertices(mesh *m, const fmpq_t distance);

/** Where edges are left open and the ends of each are near those of others, compared with their
 * extent: add a line with a weld distance that may close the surface. It is found in doubles. */
graze_status weld_advise(mesh *m);

#endif
