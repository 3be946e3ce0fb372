/* Finds the columns of a list of poses by their names, or by their number.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/convert/poses_names.h"

#include <ctype.h>

enum { NAMES = 3 };
static const char *const names[POSE_COLUMNS][NAMES] = {{"t", "time", "timestamp"},
                                                       {"x", "tx", "px"},
                                                       {"y", "ty", "py"},
                                                       {"z", "tz", "pz"},
                                                       {"qw"},
                                                       {"qx"},
                                                       {"qy"},
                                                       {"qz"},
                                                       {"m00"},
                                                       {"m01"},
                                                       {"m02"},
                                                       {"m03"},
                                                       {"m10"},
                                                       {"m11"},
                                                       {"m12"},
                                                       {"m13"},
                                                       {"m20"},
                                                       {"m21"},
                                                       {"m22"},
                                                       {"m23"},
                                                       {"m30"},
                                                       {"m31"},
                                                       {"m32"},
                                                       {"m33"}};

/* The file and the line that messages name. */
typedef struct naming {
    graze_context *context;
    const char *source;
    unsigned long line;
    pose_columns *out;
} naming;

const char *pose_column_name(int column) {
    return names[column][0];
}

static graze_status misses(const naming *n, const char *what) {
    return context_fail_in(n->context, GRAZE_EINPUT, n->source, n->line,
                           "the column %s is missing; expected "
                           "qw,qx,qy,qz with or without x,y,z, or m00 to m23",
                           what);
}

/* All or none of the columns from `first` on. */
static graze_status whole(const naming *n, int first, int count, int *some) {
    int missing = -1, found = 0;
    for (int k = first; k < first + count; k++) {
        found += n->out->place[k] >= 0;
        missing = n->out->place[k] < 0 ? k : missing;
    }
    *some = found == count;
    return found && found < count ? misses(n, names[missing][0]) : GRAZE_OK;
}

/* The column that a name stands for, or POSE_COLUMNS. */
static int column_of(field name) {
    for (int k = 0; k < POSE_COLUMNS; k++)
        for (int i = 0; i < NAMES && names[k][i]; i++)
            if (field_is(name, names[k][i]))
                return k;
    return POSE_COLUMNS;
}

static graze_status take_name(const naming *n, field name, int place) {
    int k = column_of(name);
    if (k == POSE_COLUMNS)
        return context_fail_in(n->context, GRAZE_EINPUT, n->source, n->line,
                               "the column '%.*s' is unknown; expected t (time, timestamp), then "
                               "qw,qx,qy,qz with or without x,y,z (tx, px, ...), or m00 to m33, "
                               "in any order; columns to be passed over are named as ignored",
                               FIELD_SHOWN(name));
    if (n->out->place[k] >= 0)
        return context_fail_in(n->context, GRAZE_EINPUT, n->source, n->line,
                               "the column %s stands there twice; expected once", names[k][0]);
    n->out->place[k] = place;
    return GRAZE_OK;
}

static int is_ignored(field name, const char *const *ignored, size_t count) {
    for (size_t k = 0; k < count; k++)
        if (field_is(name, ignored[k]))
            return 1;
    return 0;
}

static graze_status check_names(const naming *n) {
    int positions = 0, quaternions = 0, matrices = 0, bottom = 0;
    graze_status status = whole(n, POSE_POSITION, 3, &positions);
    if (!status)
        status = whole(n, POSE_QUATERNION, 4, &quaternions);
    if (!status)
        status = whole(n, POSE_MATRIX, 12, &matrices);
    if (!status)
        status = whole(n, POSE_MATRIX + 12, 4, &bottom);
    if (!status && !quaternions && !matrices)
        status = misses(n, names[POSE_QUATERNION][0]);
    if (!status && matrices && (quaternions || positions))
        status = context_fail_in(n->context, GRAZE_EINPUT, n->source, n->line,
                                 "matrices and other poses are mixed; expected one of them");
    n->out->has_matrices = matrices;
    return status;
}

static int begins_number(field f) {
    if (f.length && (*f.start == '-' || *f.start == '+'))
        f = (field){f.start + 1, f.length - 1};
    if (f.length && *f.start == '.')
        f = (field){f.start + 1, f.length - 1};
    return f.length && isdigit((unsigned char)*f.start);
}

/* The columns of rows without names. */
static graze_status fix_by_number(const naming *n, char separator) {
    static const int tum[] = {POSE_TIME,           POSE_POSITION,       POSE_POSITION + 1,
                              POSE_POSITION + 2,   POSE_QUATERNION + 1, POSE_QUATERNION + 2,
                              POSE_QUATERNION + 3, POSE_QUATERNION};
    size_t count = n->out->count;
    if (count == 8 && separator == ' ')
        for (int k = 0; k < 8; k++)
            n->out->place[tum[k]] = k;
    else if (count == 12 || count == 16)
        for (int k = 0; k < (int)count; k++)
            n->out->place[POSE_MATRIX + k] = k;
    else
        return context_fail_in(n->context, GRAZE_EINPUT, n->source, n->line,
                               "the first line has %zu fields and no names; expected a line of "
                               "names, or rows of TUM (time tx ty tz qx qy qz qw between blanks) "
                               "or of matrices (12 or 16 numbers, row by row)",
                               count);
    n->out->has_matrices = count > 8;
    return GRAZE_OK;
}

graze_status pose_columns_fix(pose_columns *out, int *header, graze_context *context,
                              const char *source, unsigned long line, const fields *first,
                              char separator, const char *const *ignored, size_t count) {
    naming n = {context, source, line, out};
    for (int k = 0; k < POSE_COLUMNS; k++)
        out->place[k] = -1;
    out->count = first->count;
    *header = !begins_number(field_trimmed(first->item[0]));
    if (!*header)
        return fix_by_number(&n, separator);
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < first->count && !status; k++) {
        field name = field_content(first->item[k]);
        if (!is_ignored(name, ignored, count))
            status = take_name(&n, name, (int)k);
    }
    return status ? status : check_names(&n);
}
