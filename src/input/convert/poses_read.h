/* A list of poses read from CSV.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_POSES_READ_H
#define GRAZE_CONVERT_POSES_READ_H

#include <flint/fmpq.h>
#include "input/convert/poses_columns.h"

/** One pose: the numbers of its line, exactly. */
typedef struct pose {
    fmpq_t time;
    fmpq matrix[12];    /* rows of (linear part, position); with quaternions only the positions */
    fmpq quaternion[4]; /* w, x, y, z; at first a tool's axis or angles, and found later of these
                           and of matrices */
    unsigned long line; /* in the file, from 1 */
    unsigned long row;  /* that its piece has and reports name: of its column, its number from 1, or
                           the line */
} pose;

/** Poses that are taken, and where they stand. */
typedef struct pose_choice {
    pose_naming naming;
    int has_from, has_to;
    fmpq_t from, to;     /* times, where there are such ends */
    fmpq_t scale;        /* factor of positions, positive */
    unsigned long every; /* of these poses the first, each so manieth, and the last; from 1 up */
    int numbered;        /* rows are numbers of poses, those not taken counted too */
    const char *text;    /* read in place of the file; NULL: the file is; borrowed */
    size_t length;
} pose_choice;

typedef struct pose_list {
    const char *source; /* name of the file, borrowed */
    pose_form form;
    const char *unit;   /* of `row`: line, pose, row */
    unsigned long rows; /* of the file; some may not have been taken */
    size_t count;
    pose *item;
} pose_list;

/**
 * Read a file in one of the forms of poses_columns.h, its fields between commas, semicolons or
 * blanks. Without times they are 0, 1, 2, ... Nanoseconds are added to times, and not rounded.
 * `#` lines and blank lines are skipped.
 * @param[out] out    cleared by poses_clear, also after a failure
 * @param[out] report lines on the columns
 * @return GRAZE_ESYSTEM, GRAZE_EINPUT with file, line and column, GRAZE_ELIMIT
 */
graze_status poses_read(pose_list *out, text *report, graze_context *context, const char *path,
                        const pose_choice *choice);
void poses_clear(pose_list *list);

/** Initialise the numbers of a pose, and free them. */
void pose_init(pose *p);
void pose_clear(pose *p);

#endif
