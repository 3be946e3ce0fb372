/* Orientation of facets.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MEND_ORIENT_H
#define GRAZE_MEND_ORIENT_H

#include "input/mend/mesh.h"

/**
 * Turn facets round so that neighbours at edges of two facets run against each other, shells face
 * outward, and those inside an odd number of others inward. Shells that bound nothing by themselves
 * are left as they are.
 * @param flags GRAZE_SOLID_TRIANGULATE
 * @return GRAZE_EILLEGAL the facets of a shell cannot be oriented
 */
graze_status orient_facets(mesh *m, unsigned flags);

#endif
