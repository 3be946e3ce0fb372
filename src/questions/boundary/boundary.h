/* The boundary of a sweep or unsweep by adaptive sampling ([EI] section 5, [IS] section 4.2).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A box is cut into 2^d cells again and again. Points stand on the lattice that cuts each side of
 * the box into 2^(depth + 1) parts, so that corners and centres of all cells, and the middles of
 * the smallest cells' edges, are lattice points. Every answer is exact; nothing is known between
 * the points.
 */
#ifndef GRAZE_BOUNDARY_BOUNDARY_H
#define GRAZE_BOUNDARY_BOUNDARY_H

#include "graze/boundary.h"
#include "questions/boundary/sampling.h"

/**
 * Sample a scene (graze_boundary_create); `out` is cleared by boundary_clear in either case.
 * @param low, high d rationals each, the box; both NULL: a sixteenth more than scene_box on every
 * side, so that its border is all out
 */
graze_status boundary_make(struct graze_boundary *out, graze_context *context,
                           const graze_scene *scene, const graze_boundary_options *options,
                           const fmpq *low, const fmpq *high);
void boundary_clear(struct graze_boundary *b);

#endif
