/* The names of columns in logs of poses.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_POSES_NAMES_H
#define GRAZE_CONVERT_POSES_NAMES_H

#include "base/number/text.h"
#include "input/convert/poses_angles.h"
#include "input/delimited/field.h"

/** Columns with a meaning: t; x, y, z; qw, qx, qy, qz; m00 to m33 row by row; i, j, k of a tool's
 * axis; three angles; nanoseconds, which are added to t; the number of the row in a log. */
enum {
    POSE_TIME = 0,
    POSE_POSITION = 1,
    POSE_QUATERNION = 4,
    POSE_MATRIX = 8,
    POSE_BOTTOM = POSE_MATRIX + 12,
    POSE_AXIS = POSE_MATRIX + 16,
    POSE_ANGLE = POSE_AXIS + 3,
    POSE_NANOSECONDS = POSE_ANGLE + 3, /* from here on exact, whatever rounds other numbers */
    POSE_ROW,
    POSE_COLUMNS
};

/** The first name of a column; that of an angle by the machine, NULL: any. */
const char *pose_column_name(int column, const angle_order *order);

/**
 * The column that a name stands for, or POSE_COLUMNS. Large and small letters are alike. Of names
 * in parts (field.pose.position.x, orientation_w) the last two count.
 * @param order names of the angles; NULL: there are none
 */
int pose_column_of(field name, const angle_order *order);

/** Add `; did you mean NAME?` where a name that stands for no column is near to one that does. */
void pose_name_meant(text *out, field name);

/** Are a name of a file and one of these equal but for large and small letters? */
int pose_name_is(field name, const char *known);
/** A name that says nothing of a pose: a counter, a frame, a block number or feed of a tool path.
 */
int pose_name_is_idle(field name);
/** A message's stamp: seconds in some logs, nanoseconds in others. */
int pose_name_is_stamp(field name);

#endif
