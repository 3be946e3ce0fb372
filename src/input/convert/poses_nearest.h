/* The rotation nearest to a matrix.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_POSES_NEAREST_H
#define GRAZE_CONVERT_POSES_NEAREST_H

#include "input/convert/poses_read.h"

/**
 * The unit quaternion, up to the rounding of doubles, that is nearest to a matrix: the eigenvector
 * of the largest eigenvalue of a symmetric 4x4 matrix (Horn 1987; Bar-Itzhack 2000), of the sign
 * nearer to `before`. pose_deviation has its distance.
 */
void pose_nearest(double out[4], const double matrix[9], const double before[4]);

/** The rotation of a quaternion that is not 0: 9 entries, rows. */
void pose_rotation(fmpq *out, const fmpq *q);

/** The largest absolute difference between an entry of a rotation and of a matrix, of whose rows of
 * some columns the first three count; exact. */
void rotation_distance(fmpq_t out, const fmpq *rotation, const fmpq *matrix, int columns);

/** The largest absolute difference between an entry of a pose's matrix and of the rotation that its
 * quaternion is; exact. */
void pose_deviation(fmpq_t out, const pose *p);

#endif
