/* Names of columns, whole and in parts.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/convert/poses_list.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>
#include "base/context/spelling.h"

/* Names that stand alone. */
static const struct {
    const char *name;
    int column;
} whole[] = {
    {"t", POSE_TIME},
    {"x", POSE_POSITION},
    {"y", POSE_POSITION + 1},
    {"z", POSE_POSITION + 2},
    {"qw", POSE_QUATERNION},
    {"qx", POSE_QUATERNION + 1},
    {"qy", POSE_QUATERNION + 2},
    {"qz", POSE_QUATERNION + 3},
    {"i", POSE_AXIS},
    {"j", POSE_AXIS + 1},
    {"k", POSE_AXIS + 2},
    {"row", POSE_ROW},
    {"nanoseconds", POSE_NANOSECONDS},
    {"%time", POSE_NANOSECONDS}, /* of rostopic echo -p */
    {"tx", POSE_POSITION},
    {"ty", POSE_POSITION + 1},
    {"tz", POSE_POSITION + 2},
    {"px", POSE_POSITION},
    {"py", POSE_POSITION + 1},
    {"pz", POSE_POSITION + 2},
};
enum { WHOLE = sizeof whole / sizeof *whole };

/* Last parts. */
static const char *const times[] = {"time", "timestamp", "sec", "secs", "seconds", NULL};
static const char *const parts[] = {"nanosec", "nanosecs", "nsec", "nsecs", "nanoseconds", NULL};
/* Parts before x, y, z, and before w, x, y, z. */
static const char *const positions[] = {"position", "pos", "translation", "trans",
                                        "point",    "p",   NULL};
static const char *const rotations[] = {"orientation", "quaternion", "quat", "rotation",
                                        "rot",         "ori",        "q",    NULL};

int pose_name_is(field name, const char *known) {
    return name.length == strlen(known) && strncasecmp(name.start, known, name.length) == 0;
}

static int name_is_among(field f, const char *const *list) {
    for (; *list; list++)
        if (pose_name_is(f, *list))
            return 1;
    return 0;
}

static int ends_part(char byte) {
    return byte == '.' || byte == '_' || byte == '/' || byte == ' ' || byte == ':' || byte == '-';
}

/* Take the last part off a name. */
static field take_name_part(field *rest) {
    size_t at = rest->length;
    while (at && !ends_part(rest->start[at - 1]))
        at--;
    field out = {rest->start + at, rest->length - at};
    rest->length = at ? at - 1 : 0;
    return out;
}

const char *pose_column_name(int column, const angle_order *order) {
    static const char *const matrix[] = {"m00", "m01", "m02", "m03", "m10", "m11", "m12", "m13",
                                         "m20", "m21", "m22", "m23", "m30", "m31", "m32", "m33"};
    if (column >= POSE_MATRIX && column < POSE_AXIS)
        return matrix[column - POSE_MATRIX];
    if (column >= POSE_ANGLE && column < POSE_NANOSECONDS)
        return order ? order->name[column - POSE_ANGLE] : "an angle";
    for (int k = 0; k < WHOLE; k++)
        if (whole[k].column == column)
            return whole[k].name;
    return "";
}

/* The column of a name in parts. */
static int column_of_parts(field name) {
    field rest = name, last = take_name_part(&rest), before = take_name_part(&rest);
    if (name_is_among(last, times))
        return POSE_TIME;
    if (name_is_among(last, parts))
        return POSE_NANOSECONDS;
    for (int k = 0; k < 4; k++) {
        const char axis[] = {"wxyz"[k], '\0'}, quaternion[] = {'q', "wxyz"[k], '\0'};
        if (pose_name_is(last, quaternion) ||
            (pose_name_is(last, axis) && name_is_among(before, rotations)))
            return POSE_QUATERNION + k;
        if (k && pose_name_is(last, axis) && name_is_among(before, positions))
            return POSE_POSITION + k - 1;
    }
    return POSE_COLUMNS;
}

int pose_column_of(field name, const angle_order *order) {
    for (int k = 0; k < 3 && order; k++)
        if (field_is(name, order->name[k])) /* T may be an angle, t is the time */
            return POSE_ANGLE + k;
    for (int k = 0; k < WHOLE; k++)
        if (pose_name_is(name, whole[k].name))
            return whole[k].column;
    for (int k = POSE_MATRIX; k < POSE_AXIS; k++)
        if (pose_name_is(name, pose_column_name(k, NULL)))
            return k;
    for (int k = 0; k < 3 && order; k++)
        if (pose_name_is(name, order->name[k]))
            return POSE_ANGLE + k;
    return column_of_parts(name);
}

int pose_name_is_idle(field name) {
    if (pose_name_is(name, "n") || pose_name_is(name, "f") || pose_name_is(name, "feed"))
        return 1; /* block number and feed of a tool path */
    field last = take_name_part(&name), before = take_name_part(&name);
    return pose_name_is(last, "seq") || (pose_name_is(last, "id") && pose_name_is(before, "frame"));
}

int pose_name_is_stamp(field name) {
    return pose_name_is(take_name_part(&name), "stamp");
}

static const char *near_in_list(field f, const char *const *list) {
    size_t count = 0;
    while (list[count])
        count++;
    return near_among(f.start, f.length, list, count);
}

void pose_name_meant(text *out, field name) {
    static const char axes[] = "wxyzWXYZ";
    int code = name.length &&
               (strchr("(%", *name.start) || (name.length > 1 && strchr("GMNOgmno", *name.start) &&
                                              isdigit((unsigned char)name.start[1])));
    field last = take_name_part(&name), before = take_name_part(&name);
    int is_axis = last.length == 1 && strchr(axes, *last.start);
    const char *meant = near_in_list(is_axis ? before : last, is_axis ? rotations : times);
    if (!meant)
        meant = near_in_list(is_axis ? before : last, is_axis ? positions : parts);
    if (code)
        text_put(out, "; this is G-code: expected are rows x,y,z of its positions");
    else if (meant)
        text_format(out, is_axis ? "; did you mean %s.%.*s?" : "; did you mean %s?", meant,
                    FIELD_SHOWN(last));
}
