/* The columns of a list of poses, fixed by its first line.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_POSES_COLUMNS_H
#define GRAZE_CONVERT_POSES_COLUMNS_H

#include "base/number/text.h"
#include "input/convert/poses_names.h"

/** How the rows give rotations. */
typedef enum pose_form {
    POSES_OF_POSITIONS, /* not at all */
    POSES_OF_QUATERNIONS,
    POSES_OF_MATRICES,
    POSES_OF_AXES, /* of a tool: the least rotation from (0, 0, 1) */
    POSES_OF_ANGLES
} pose_form;

/** The caller's description of columns; all borrowed. */
typedef struct pose_naming {
    const char *const *ignored; /* names to pass over; `*` at an end stands for any end */
    size_t ignored_count;
    const char *columns;      /* NAME=COLUMN,..., COLUMN as in the file; NULL: none */
    const angle_order *order; /* of angles; NULL: there are none */
} pose_naming;

typedef struct pose_columns {
    int place[POSE_COLUMNS]; /* of each in a row, from 0; -1 where there is none */
    size_t count;            /* of a row */
    pose_form form;
} pose_columns;

/**
 * Fix the columns by the first line of a file. Without names it is a row of a TUM trajectory (time,
 * position, quaternion x, y, z, w: 8 numbers between blanks), or of matrices (12 or 16 numbers, row
 * by row). Columns that are neither known nor named are refused, but for counters and frames: a
 * position or time under another name is not to be lost.
 * @param[out] header 1 if the line has the names, 0 if it is a row
 * @param[out] report lines on names that were taken for others, and on columns passed over
 * @param source      file, for messages
 * @return GRAZE_EINPUT
 */
graze_status pose_columns_fix(pose_columns *out, int *header, text *report, graze_context *context,
                              const char *source, unsigned long line, const fields *first,
                              char separator, const pose_naming *naming);

#endif
