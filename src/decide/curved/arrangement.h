/* The central arrangement of the tangent planes of some surfaces: its open cells and its rays.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_ARRANGEMENT_H
#define GRAZE_CURVED_ARRANGEMENT_H

#include "decide/curved/taylor.h"

enum { ARRANGEMENT_RAYS = (CSG_FREE_MOST + 3) * (CSG_FREE_MOST + 2) };

/** The rays, in both directions, in which the planes of the members and of the coordinates meet. */
typedef struct arrangement {
    int dimension, count, ray_count;
    value *ray;                          /* `dimension` elements each */
    uint32_t positive[ARRANGEMENT_RAYS]; /* members whose gradient is positive along the ray */
    uint32_t negative[ARRANGEMENT_RAYS];
} arrangement;

/** Make the arrangement of the members in `mask`; their gradients are not zero. */
void arrangement_init(arrangement *a, moment_field *f, const taylor *member, int count,
                      uint32_t mask);
void arrangement_clear(arrangement *a);

/** Does a ray lie in the closed cell that a pattern of the members in `mask` has? */
int arrangement_in_cell(const arrangement *a, int ray, uint32_t mask, unsigned pattern);

/** Has the pattern an open cell, in which each member's gradient has the pattern's sign? The sum of
 * the rays in the closed cell shows it. */
int arrangement_has(const arrangement *a, uint32_t mask, unsigned pattern);

/** out = a . b, a x b, of vectors of `dimension`, of three. */
void field_dot(value *out, moment_field *f, const value *a, const value *b, int dimension);
void field_cross(value *out, moment_field *f, const value *a, const value *b);

#endif
