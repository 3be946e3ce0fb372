/* Transforms of a motion file: JSON to affine maps over a stretch of a piece (src/cli/formats.md,
 * Motions). SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MOTION_TRANSFORM_H
#define GRAZE_MOTION_TRANSFORM_H

#include "motion/affine.h"
#include "motion/entry.h"

/** Places in s at which the turns of a transform cut its piece, ascending, each once, from 0 to 1.
 */
typedef struct cut_list {
    size_t count, capacity; /* places up to `capacity` are initialised */
    fmpq *place;
} cut_list;

void cut_list_init(cut_list *cuts);
void cut_list_clear(cut_list *cuts);
/** @return GRAZE_ELIMIT more parts than the limit `pieces`; what transform_map returns */
graze_status transform_cuts(cut_list *cuts, graze_context *context, const json *transform);

/**
 * The map of a transform over one stretch between two of its cuts.
 * @param[out] out initialised, of the stretch's dimension
 * @return GRAZE_EINPUT keys, types, expressions; GRAZE_EILLEGAL an axis whose length is not a
 * rational function, vanishes or has a pole, a quaternion that vanishes, and what the
 * stretch's fault says: an entry with a pole, or a singular scale or matrix; GRAZE_ELIMIT
 */
graze_status transform_map(affine *out, graze_context *context, const json *transform,
                           const stretch *part);

/* Rotations, in rotation.c. `out` is initialised; the value is that of the key. */

/** {"tan_half": e, "times": n, "center": [...], "axis": [...]} */
graze_status rotation_by_tangent(affine *out, graze_context *context, const json *value,
                                 const stretch *part);
/** {"quarters": n, "center": [...], "axis": [...]} */
graze_status rotation_by_quarters(affine *out, graze_context *context, const json *value,
                                  const stretch *part);
/** The integer of "quarters" in the value of a turn. */
graze_status rotation_quarters(fmpz_t out, graze_context *context, const json *value);
/** [w, x, y, z]; not about a center yet. */
graze_status rotation_by_quaternion(affine *out, graze_context *context, const json *value,
                                    const stretch *part);

/**
 * The rotation of a quaternion w, x, y, z, of any length; in E^2 x and y are zero and w + iz is the
 * half angle as a complex number. Only the ratios count, so a pole of the four is harmless.
 * @return GRAZE_EILLEGAL at `where` if they vanish together on the stretch [lo, hi] of t
 */
graze_status rotation_of(affine *out, graze_context *context, const json *where, fmpz_poly_q_t q[4],
                         const fmpq_t lo, const fmpq_t hi);

#endif
