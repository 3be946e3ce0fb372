/* The box of a bounded quadric. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_FILTER_SURFACE_BOX_H
#define GRAZE_FILTER_SURFACE_BOX_H

#include "input/csg/csg.h"
#include "input/solid/tree.h"

/** A box outside of which the polynomial is positive; 0 if none is known: it is no quadric whose
 * form is positive definite (proofs/surfaces.md C104). */
int surface_box(box *out, const csg_surface *surface, int dimension);

#endif
