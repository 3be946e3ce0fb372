/* The columns of a list of poses.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_POSES_NAMES_H
#define GRAZE_CONVERT_POSES_NAMES_H

#include "base/context/context.h"
#include "input/delimited/field.h"

/** Columns with a meaning: t; x, y, z; qw, qx, qy, qz; m00 to m33 row by row. */
enum { POSE_TIME = 0, POSE_POSITION = 1, POSE_QUATERNION = 4, POSE_MATRIX = 8, POSE_COLUMNS = 24 };

typedef struct pose_columns {
    int place[POSE_COLUMNS]; /* of each in a row, from 0; -1 where there is none */
    size_t count;            /* of a row */
    int has_matrices;
} pose_columns;

/** The first name of a column. */
const char *pose_column_name(int column);

/**
 * Fix the columns by the first line of a file. Without names it is a row of a TUM trajectory (time,
 * position, quaternion x, y, z, w: 8 numbers between blanks), or of matrices (12 or 16 numbers, row
 * by row).
 * @param[out] header 1 if the line has the names, 0 if it is a row
 * @param source      file, for messages
 * @param ignored     names of `count` columns to pass over
 * @return GRAZE_EINPUT
 */
graze_status pose_columns_fix(pose_columns *out, int *header, graze_context *context,
                              const char *source, unsigned long line, const fields *first,
                              char separator, const char *const *ignored, size_t count);

#endif
