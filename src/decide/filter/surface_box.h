/* The box of a bounded quadric. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_FILTER_SURFACE_BOX_H
#define GRAZE_FILTER_SURFACE_BOX_H

#include "input/csg/csg.h"
#include "input/solid/tree.h"

/** A box such that the polynomial is positive outside; 0 if none is known: only a quadric with a
 * positive definite form has one (proofs/surfaces.md C104). */
int surface_box(box *out, const csg_surface *surface, int dimension);

#endif
