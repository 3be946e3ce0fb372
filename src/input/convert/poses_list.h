/* Lists of poses: columns, angles, nearest rotations and what stands between rows.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_CONVERT_POSES_LIST_H
#define GRAZE_INPUT_CONVERT_POSES_LIST_H

#include <mpfr.h>
#include "input/convert/convert.h"
#include "input/delimited/delimited.h"

/* The names of columns in logs of poses. */

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
    POSE_NANOSECONDS = POSE_ANGLE + 3, /* values of this and later columns are never rounded */
    POSE_ROW,
    POSE_COLUMNS
};

/** The first name of a column. Angles have the machine's names, or "an angle" if `order` is NULL.
 */
const char *pose_column_name(int column, const angle_order *order);

/**
 * The column that a name stands for, or POSE_COLUMNS. Large and small letters are alike. Of names
 * in parts (field.pose.position.x, orientation_w) the last two count.
 * @param order names of the angles; NULL: there are none
 */
int pose_column_of(field name, const angle_order *order);

/** Add `; did you mean NAME?` where a name that stands for no column is near to one that does. */
void pose_name_meant(text *out, field name);

/** 1 if a name in a file equals a known one, letters of either case being alike. */
int pose_name_is(field name, const char *known);
/** 1 if a name means nothing for a pose: a counter, a frame, or a tool path's block number or feed.
 */
int pose_name_is_idle(field name);
/** 1 if a name is that of a message's stamp, which is in seconds in some logs, in nanoseconds in
 * others. */
int pose_name_is_stamp(field name);

/* The columns of a list of poses, fixed by its first line. */

/** How the rows give rotations. */
typedef enum pose_form {
    POSES_OF_POSITIONS, /* no rotations */
    POSES_OF_QUATERNIONS,
    POSES_OF_MATRICES,
    POSES_OF_AXES, /* a tool's axis: the least rotation from (0, 0, 1) to it */
    POSES_OF_ANGLES
} pose_form;

typedef struct pose_columns {
    int place[POSE_COLUMNS]; /* place of each column in a row, from 0; -1: the file lacks it */
    size_t count;            /* columns of a row */
    pose_form form;
} pose_columns;

/**
 * Fix the columns by the first line of a file. A line without names is a row of a TUM trajectory
 * (time, position, quaternion x, y, z, w: 8 numbers between blanks), or of matrices (12 or 16
 * numbers, row by row). Columns that are neither known nor named are refused, but for counters and
 * frames: a position or time under another name is not to be lost.
 * @param[out] header 1 if the line has the names, 0 if it is a row
 * @param[out] report lines on names that were taken for others, and on columns passed over
 * @param source      file, for messages
 * @return GRAZE_EINPUT
 */
graze_status pose_columns_fix(pose_columns *out, int *header, text *report, graze_context *context,
                              const char *source, unsigned long line, const fields *first,
                              char separator, const pose_naming *naming);

/* A list of poses read from CSV. */

/** One pose: the numbers of its line, exactly. */
typedef struct pose {
    fmpq *time;         /* first of all numbers */
    fmpq *matrix;       /* rows of (linear part, position); with quaternions only the positions */
    fmpq *quaternion;   /* w, x, y, z. Rows with an axis or angles first have their three numbers
                         * here; their quaternions, and those of matrices, are computed after
                         * reading */
    unsigned long line; /* number of the line in the file, from 1 */
    unsigned long row;  /* row number of the pose's piece, which reports name: the value in the
                         * column of row numbers, or else the pose's number from 1, or its line */
} pose;

typedef struct pose_list {
    const char *source; /* name of the file, borrowed */
    pose_form form;
    int dimension;      /* of the motion */
    const char *unit;   /* name of what `row` counts: line, pose, row */
    unsigned long rows; /* poses in the file, taken or not */
    size_t count;
    pose *item;
} pose_list;

/**
 * Read a file or text in one of the forms above, its fields between commas, semicolons or blanks.
 * Poses without times have the times 0, 1, 2, ... Nanoseconds are added to times, and not rounded.
 * `#` lines and blank lines are skipped.
 * @param[out] out zeroed by the caller, cleared by pose_list_clear, also after a failure
 * @param[out] report lines on the columns
 * @return GRAZE_ESYSTEM, GRAZE_EINPUT with file, line and column, GRAZE_ELIMIT
 */
graze_status poses_read(pose_list *out, text *report, graze_context *context, const char *path,
                        const pose_choice *choice);
void pose_list_clear(pose_list *list);

/** Initialise the numbers of a pose, and free them. */
void pose_init(pose *p);
void pose_clear(pose *p);

/* SLERP between poses: how far linear quaternions are from it, and poses between that come near. */

/** The way from one pose to the next, with sums and bounds over all ways so far. Only the tolerance
 * is set at first. */
typedef struct slerp_course {
    const fmpq *tolerance; /* bound of the angle to SLERP at each time; NULL: no halving */
    int halvings;          /* how often this way is halved */
    size_t pieces;         /* number of pieces of all ways */
    double worst;          /* bound of the angle to SLERP on all ways, radians */
    unsigned long row; /* row of the pose to which the way with that bound leads; 0: none turns */
} slerp_course;

/** Look at the way from pose i - 1 of a list to pose i: how often it is halved and how far it then
 * is from SLERP. If ways may be halved, quaternion i is multiplied by a factor that brings it near
 * to length 1.
 * @return GRAZE_EINPUT a quaternion that is 0, or opposite to the one before; GRAZE_ELIMIT,
 * GRAZE_ECANCELED */
graze_status slerp_look(slerp_course *s, graze_context *context, const pose_list *list, size_t i);

/** The pose in the middle of two. @param[out] out initialised */
void slerp_middle(pose *out, const slerp_course *s, const pose *from, const pose *to);

void slerp_report(text *t, const slerp_course *s, const char *unit);

/* Rotations of poses that have a tool's axis, or angles. */

/**
 * Find the quaternions of a list of axes or angles, each with the sign that is nearer to the one
 * before.
 * @param[out] report the largest error
 * @param order of angles
 * @return GRAZE_EINPUT an axis is zero or opposite to (0, 0, 1), or an error exceeds the tolerance;
 * GRAZE_ECANCELED
 */
graze_status poses_turn(text *report, graze_context *context, pose_list *list,
                        const angle_order *order, const fmpq_t tolerance);

/** The number of bits of an angle with which the errors of three angles together stay within the
 * tolerance; tolerance 0 asks for the most bits. */
slong bits_within(const fmpq_t tolerance);

/** Sign of the scalar product of a pose's quaternion with that of the pose before. */
int pose_along(const pose *p);
/** Change the sign of a pose's quaternion. */
void pose_negate(pose *p);

/* Joints that move uniformly. */

/** Write the motion of a chain of `count` joints as `pieces` pieces on equal parts of [0, 1].
 * @return GRAZE_ECANCELED
 */
graze_status chain_pieces(json_writer *out, graze_context *context, const target *goal,
                          const joint *joints, size_t count, unsigned long pieces);
/** f for the functions of angle.h at the part k/n of a joint's turn. */
void turn_fraction(fmpq_t out, const joint *j, unsigned long k, unsigned long n);
/** ceil(|degrees| / 90) and at least 1, or 0 where that exceeds the limit `pieces`. */
unsigned long quarters_above(const graze_context *context, const joint *j);

#endif
