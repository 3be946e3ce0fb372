/* Finds the columns of a list of poses by their names, or by their number.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/convert/poses_list.h"

#include <ctype.h>
#include "base/context/scope.h"
#include "base/context/spelling.h"

/* The first line of a file, and its place for messages. */
typedef struct naming {
    graze_context *context;
    const char *source;
    unsigned long line;
    const fields *first;
    const pose_naming *given;
    pose_columns *out;
    text *passed; /* names of columns that are passed over unasked */
} naming;

static graze_status misses(const naming *n, const char *what) {
    return context_fail_in(n->context, GRAZE_EINPUT, n->source, n->line,
                           "the column %s is missing; expected %s or m00 to m23", what,
                           n->given->dimension == 2
                               ? "x,y, perhaps with qw,qz, or theta in radians, or a "
                                 "machine's angle about z,"
                               : "x,y,z, perhaps with qw,qx,qy,qz, or a tool's i,j,k, "
                                 "or three angles,");
}

/* Check that the file has none of `count` columns from `first` on, or all of them whose bits are in
 * `must`; *some is 1 if it has one. */
static graze_status whole(const naming *n, int first, int count, unsigned must, int *some) {
    int missing = -1;
    *some = 0;
    for (int k = first; k < first + count; k++) {
        *some |= n->out->place[k] >= 0;
        missing = n->out->place[k] < 0 && must >> (k - first) & 1 ? k : missing;
    }
    return *some && missing >= 0 ? misses(n, pose_column_name(missing, n->given->order)) : GRAZE_OK;
}

/* The next NAME=COLUMN of a list; 0 at its end. */
static int next_naming(field *name, field *column, const char **at) {
    if (!*at || !**at)
        return 0;
    size_t length = strcspn(*at, ","), before = strcspn(*at, "=,");
    *name = (field){*at, before};
    *column = (field){*at + before + 1, length > before ? length - before - 1 : 0};
    *at += length + ((*at)[length] == ',');
    return 1;
}

/* The first name of the file that is near to a missing one; empty where none is. */
static field near_name(const naming *n, field missing) {
    char wanted[32];
    const char *name = wanted;
    size_t length = missing.length < sizeof wanted ? missing.length : 0;
    memcpy(wanted, missing.start, length);
    wanted[length] = '\0';
    for (size_t i = 0; i < n->first->count; i++) {
        field one = field_content(n->first->item[i]);
        if (near_among(one.start, one.length, &name, 1))
            return one;
    }
    return (field){"", 0};
}

static graze_status refuse_missing(const naming *n, field column) {
    field meant = near_name(n, column);
    return context_fail_in(n->context, GRAZE_EINPUT, n->source, n->line,
                           "the column '%.*s' is missing; expected it among the names of this "
                           "line%s%.*s%s",
                           FIELD_SHOWN(column), meant.length ? "; did you mean " : "",
                           FIELD_SHOWN(meant), meant.length ? "?" : "");
}

/* Take the columns that the caller names. */
static graze_status take_given(const naming *n) {
    const char *at = n->given->columns;
    for (field name, column; next_naming(&name, &column, &at);) {
        int k = pose_column_of(name, n->given->order), place = -1;
        for (size_t i = 0; i < n->first->count; i++)
            if (field_equal(field_content(n->first->item[i]), column))
                place = (int)i;
        if (k == POSE_COLUMNS || !column.length)
            return context_fail(
                n->context, GRAZE_EUSE,
                "columns: '%.*s': expected NAME=COLUMN, NAME one of t, "
                "nanoseconds, row, x, y, z, qw, qx, qy, qz, i, j, k, m00 to m33 or an "
                "angle of the machine",
                FIELD_SHOWN(name));
        if (place < 0)
            return refuse_missing(n, column);
        if (n->out->place[k] >= 0)
            return context_fail(n->context, GRAZE_EUSE, "columns: %s is named twice; expected once",
                                pose_column_name(k, n->given->order));
        n->out->place[k] = place;
    }
    return GRAZE_OK;
}

static int is_named_by_caller(const naming *n, int column) {
    const char *at = n->given->columns;
    for (field name, other; next_naming(&name, &other, &at);)
        if (pose_column_of(name, n->given->order) == column)
            return 1;
    return 0;
}

static int is_ignored(const naming *n, field name) {
    for (size_t k = 0; k < n->given->ignored_count; k++) {
        const char *one = n->given->ignored[k];
        size_t length = strlen(one);
        if (field_is(name, one) || (length && one[length - 1] == '*' && name.length >= length - 1 &&
                                    memcmp(name.start, one, length - 1) == 0))
            return 1;
    }
    return 0;
}

static int is_placed(const naming *n, int place) {
    for (int k = 0; k < POSE_COLUMNS; k++)
        if (n->out->place[k] == place)
            return 1;
    return 0;
}

/* A name of the file; control bytes do not reach a terminal. */
static void put_file_name(text *t, field name) {
    for (size_t k = 0; k < name.length; k++)
        text_bytes(t, iscntrl((unsigned char)name.start[k]) ? "?" : name.start + k, 1);
}

static void pass_over(naming *n, field name) {
    text_put(n->passed, n->passed->length ? ", " : "");
    put_file_name(n->passed, name);
}

/* Refuse a stamp that is the only time of the file: the caller is to say in which unit it is. */
static graze_status refuse_stamp(const naming *n, field name) {
    return context_fail_in(n->context, GRAZE_EINPUT, n->source, n->line,
                           "the column '%.*s' is in seconds in some logs and in nanoseconds in "
                           "others; expected it named as the column t or nanoseconds",
                           FIELD_SHOWN(name));
}

static graze_status refuse_name(const naming *n, field name) {
    static const char letters[] = "ABCabc";
    if (name.length == 1 && strchr(letters, *name.start) &&
        (!n->given->order || n->given->order->radians))
        return context_fail_in(n->context, GRAZE_EINPUT, n->source, n->line,
                               "the column '%.*s' is an angle, whose meaning depends on the "
                               "machine; expected its name: kuka, cnc, ...",
                               FIELD_SHOWN(name));
    HELD(text, meant);
    pose_name_meant(&meant, name);
    return context_fail_in(
        n->context, GRAZE_EINPUT, n->source, n->line,
        "the column '%.*s' is unknown; expected t (time, timestamp), x,y,z (tx, pos_x, position.x, "
        "...), qw,qx,qy,qz (orientation.w, ...), i,j,k, %sor m00 to m33, in any order; other "
        "columns are named as one of these (`--columns`), or as ignored (`--ignore`)%s",
        FIELD_SHOWN(name),
        n->given->dimension == 2 ? "theta in radians or yaw (`--angles rpy`), " : "",
        meant.data ? meant.data : "");
}

/* Seconds and nanoseconds are one time: where the caller names one, no other column adds to it. */
static int is_time_by_caller(const naming *n, int column) {
    return (column == POSE_TIME || column == POSE_NANOSECONDS) &&
           (is_named_by_caller(n, POSE_TIME) || is_named_by_caller(n, POSE_NANOSECONDS));
}

static graze_status take_name(naming *n, field name, int place) {
    int k = pose_column_of(name, n->given->order);
    if (k == POSE_COLUMNS ? pose_name_is_idle(name)
                          : is_named_by_caller(n, k) || is_time_by_caller(n, k)) {
        pass_over(n, name);
        return GRAZE_OK;
    }
    if (k == POSE_COLUMNS)
        return refuse_name(n, name);
    if (n->out->place[k] >= 0)
        return context_fail_in(n->context, GRAZE_EINPUT, n->source, n->line,
                               "the column %s stands there twice; expected once",
                               pose_column_name(k, n->given->order));
    n->out->place[k] = place;
    return GRAZE_OK;
}

/* Two passes: a stamp waits until it is known whether other columns have the time. */
static graze_status take_names(naming *n) {
    TRY(take_given(n));
    for (int stamps = 0; stamps < 2; stamps++)
        for (size_t k = 0; k < n->first->count; k++) {
            field name = field_content(n->first->item[k]);
            if (is_placed(n, (int)k) || is_ignored(n, name) || pose_name_is_stamp(name) != stamps)
                continue;
            if (!stamps)
                TRY(take_name(n, name, (int)k));
            else if (n->out->place[POSE_TIME] < 0 && n->out->place[POSE_NANOSECONDS] < 0)
                TRY(refuse_stamp(n, name));
            else
                pass_over(n, name);
        }
    return GRAZE_OK;
}

/* Check that the columns give a rotation in one form. */
static graze_status check_names(const naming *n) {
    int positions = 0, quaternions = 0, matrices = 0, bottom = 0, axes = 0, angles = 0;
    int flat = n->given->dimension == 2;
    const angle_order *order = n->given->order;
    TRY(whole(n, POSE_POSITION, 3, flat ? 3 : 7, &positions));
    TRY(whole(n, POSE_QUATERNION, 4, flat ? 9 : 15, &quaternions)); /* flat: w and z */
    TRY(whole(n, POSE_MATRIX, 12, ~0U, &matrices));
    TRY(whole(n, POSE_BOTTOM, 4, ~0U, &bottom));
    TRY(whole(n, POSE_AXIS, 3, ~0U, &axes));
    TRY(whole(n, POSE_ANGLE, 3, flat || (order && order->may_miss) ? 0 : ~0U, &angles));
    if (!positions && !quaternions && !matrices && !axes && !angles)
        return misses(n, order ? order->name[0] : "x");
    if (quaternions + matrices + axes + angles + (matrices && positions) > 1)
        return context_fail_in(n->context, GRAZE_EINPUT, n->source, n->line,
                               "matrices, quaternions, axes and angles are mixed; expected one of "
                               "them");
    n->out->form = quaternions ? POSES_OF_QUATERNIONS
                   : matrices  ? POSES_OF_MATRICES
                   : axes      ? POSES_OF_AXES
                   : angles    ? POSES_OF_ANGLES
                               : POSES_OF_POSITIONS;
    return GRAZE_OK;
}

static int begins_number(field f) {
    if (f.length && (*f.start == '-' || *f.start == '+'))
        f = (field){f.start + 1, f.length - 1};
    if (f.length && *f.start == '.')
        f = (field){f.start + 1, f.length - 1};
    return f.length && isdigit((unsigned char)*f.start);
}

/* Fix the columns of a file without names by their number. */
static graze_status fix_by_number(const naming *n, char separator) {
    static const int tum[] = {POSE_TIME,           POSE_POSITION,       POSE_POSITION + 1,
                              POSE_POSITION + 2,   POSE_QUATERNION + 1, POSE_QUATERNION + 2,
                              POSE_QUATERNION + 3, POSE_QUATERNION};
    size_t count = n->out->count;
    if (n->given->columns)
        return context_fail_in(n->context, GRAZE_EINPUT, n->source, n->line,
                               "the first line has no names; expected those of the columns");
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
    n->out->form = count > 8 ? POSES_OF_MATRICES : POSES_OF_QUATERNIONS;
    return GRAZE_OK;
}

/* Report names of the file that differ from the columns' first names, and names passed over without
 * the caller's wish. */
static void report_names(text *report, const naming *n) {
    int told = 0;
    for (int k = 0; k < POSE_COLUMNS; k++) {
        const char *known = pose_column_name(k, n->given->order);
        if (n->out->place[k] < 0)
            continue;
        field name = field_content(n->first->item[n->out->place[k]]);
        if (pose_name_is(name, known))
            continue;
        text_put(report, told++ ? ", " : "columns: ");
        text_format(report, "%s is '", known);
        put_file_name(report, name);
        text_put(report, "'");
    }
    text_put(report, told ? "\n" : "");
    if (n->passed->length)
        text_format(report, "passed over: %s\n", n->passed->data);
}

graze_status pose_columns_fix(pose_columns *out, int *header, text *report, graze_context *context,
                              const char *source, unsigned long line, const fields *first,
                              char separator, const pose_naming *given) {
    naming n = {context, source, line, first, given, out, NULL};
    for (int k = 0; k < POSE_COLUMNS; k++)
        out->place[k] = -1;
    out->count = first->count;
    *header = !begins_number(field_trimmed(first->item[0]));
    if (!*header)
        return fix_by_number(&n, separator);
    HELD(text, passed);
    n.passed = &passed;
    TRY(take_names(&n));
    TRY(check_names(&n));
    report_names(report, &n);
    return GRAZE_OK;
}
