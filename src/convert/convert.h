/* Motion files from what people have: angles in degrees, screws, joints, lists of poses.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * What is made is a text in the form of a motion file, read and checked before it is handed out,
 * and a report of what was approximated with proved bounds.
 */
#ifndef GRAZE_CONVERT_CONVERT_H
#define GRAZE_CONVERT_CONVERT_H

#include <flint/fmpq.h>
#include "convert/joint.h"

/** A motion file and its report in the making; for text_init and text_clear. */
typedef struct conversion {
    text motion, report;
} conversion;

/** One turn at no particular speed, of which only the end is approximated (rotation.c). */
graze_status convert_rotation(conversion *out, graze_context *context, const target *goal,
                              const joint *turn);
/** Joints that all move uniformly, cut into pieces until they are near enough (uniform.c). */
graze_status convert_joints(conversion *out, graze_context *context, const target *goal,
                            const joint *joints, size_t count);
/** Poses from a CSV file (poses.c); `affine`: matrices as they are. */
graze_status convert_poses(conversion *out, graze_context *context, const char *path, int affine,
                           const fmpq_t tolerance);

/** Write the pieces of a chain cut into `pieces` equal parts of [0, 1], one text of `pieces`.
 * @param bits of each joint's angles, `count` of them
 */
void chain_pieces(text *out, const target *goal, const joint *joints, const slong *bits,
                  size_t count, unsigned long pieces);
/** f for the functions of angle.h at the part k/n of a joint's turn. */
void turn_fraction(fmpq_t out, const joint *j, unsigned long k, unsigned long n);
/** ceil(|degrees| / 90) and at least 1, or 0 where that exceeds the limit `pieces`. */
unsigned long quarters_above(const graze_context *context, const joint *j);

#endif
