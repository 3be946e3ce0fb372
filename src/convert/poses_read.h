/* A list of poses read from CSV.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_POSES_READ_H
#define GRAZE_CONVERT_POSES_READ_H

#include <flint/fmpq.h>
#include "context/context.h"

/** One pose: the numbers of its line, exactly. */
typedef struct pose {
    fmpq_t time;
    fmpq matrix[12];    /* rows of (linear part, position); with quaternions only the positions */
    fmpq quaternion[4]; /* w, x, y, z; found later where the file has matrices */
    unsigned long line; /* in the file, from 1 */
} pose;

typedef struct pose_list {
    const char *source; /* name of the file, borrowed */
    int has_matrices;
    size_t count;
    pose *item;
} pose_list;

/**
 * Read a CSV file whose line of names has `qw,qx,qy,qz` with or without `x,y,z`, or `m00` to `m23`
 * row by row with or without `m30` to `m33`, in any order; with a column `t`, or the times are 0,
 * 1, 2, ... Other columns are refused by name: a position or time under another name is not to be
 * lost. `#` lines and blank lines are skipped.
 * @param[out] out cleared by poses_clear, also after a failure
 * @return GRAZE_ESYSTEM, GRAZE_EINPUT with file, line and column, GRAZE_ELIMIT
 */
graze_status poses_read(pose_list *out, graze_context *context, const char *path);
void poses_clear(pose_list *list);

#endif
