/* Reads lists of poses.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "convert/poses_read.h"

#include <stdlib.h>
#include <string.h>
#include "context/array.h"
#include "context/file.h"
#include "number/rational.h"
#include "table/stream.h"

enum { TIME = 0, POSITION = 1, QUATERNION = 4, MATRIX = 8, COLUMNS = 24 };
static const char *const names[COLUMNS] = {"t",   "x",   "y",   "z",   "qw",  "qx",  "qy",  "qz",
                                           "m00", "m01", "m02", "m03", "m10", "m11", "m12", "m13",
                                           "m20", "m21", "m22", "m23", "m30", "m31", "m32", "m33"};

typedef struct reading {
    graze_context *context;
    pose_list *list;
    size_t capacity;
    unsigned long line;
    fields cut;         /* of that line */
    int place[COLUMNS]; /* of each known column in the file, or -1 */
    int columns;        /* of the file */
} reading;

static graze_status misses(const reading *r, const char *what) {
    return context_fail_in(r->context, GRAZE_EINPUT, r->list->source, r->line,
                           "the column %s is missing; expected "
                           "qw,qx,qy,qz with or without x,y,z, or m00 to m23",
                           what);
}

/* All or none of the columns from `first` on. */
static graze_status whole(const reading *r, int first, int count, int *some) {
    int missing = -1, found = 0;
    for (int k = first; k < first + count; k++) {
        found += r->place[k] >= 0;
        missing = r->place[k] < 0 ? k : missing;
    }
    *some = found == count;
    return found && found < count ? misses(r, names[missing]) : GRAZE_OK;
}

static graze_status read_column_name(reading *r, field name) {
    int k = 0;
    while (k < COLUMNS && !field_is(name, names[k]))
        k++;
    if (k == COLUMNS)
        return context_fail_in(r->context, GRAZE_EINPUT, r->list->source, r->line,
                               "the column '%.*s' is unknown; expected t, then "
                               "qw,qx,qy,qz with or without x,y,z, or m00 to m33, in any order",
                               FIELD_SHOWN(name));
    if (r->place[k] >= 0)
        return context_fail_in(r->context, GRAZE_EINPUT, r->list->source, r->line,
                               "the column %s stands there twice; expected once", names[k]);
    r->place[k] = r->columns++;
    return GRAZE_OK;
}

static graze_status read_names(reading *r) {
    graze_status status = GRAZE_OK;
    for (int k = 0; k < COLUMNS; k++)
        r->place[k] = -1;
    for (size_t k = 0; k < r->cut.count && !status; k++)
        status = read_column_name(r, field_trimmed(r->cut.item[k]));
    if (status)
        return status;
    int positions = 0, quaternions = 0, matrices = 0, bottom = 0;
    status = whole(r, POSITION, 3, &positions);
    if (!status)
        status = whole(r, QUATERNION, 4, &quaternions);
    if (!status)
        status = whole(r, MATRIX, 12, &matrices);
    if (!status)
        status = whole(r, MATRIX + 12, 4, &bottom);
    if (!status && !quaternions && !matrices)
        status = misses(r, names[QUATERNION]);
    if (!status && matrices && (quaternions || positions))
        status = context_fail_in(r->context, GRAZE_EINPUT, r->list->source, r->line,
                                 "matrices and other poses are mixed; expected one of them");
    r->list->has_matrices = matrices;
    return status;
}

static pose *append_pose(reading *r) {
    pose_list *list = r->list;
    if (!array_reserve(&list->item, &r->capacity, list->count + 1, sizeof *list->item))
        return NULL;
    pose *p = list->item + list->count++;
    fmpq_init(p->time);
    for (int k = 0; k < 12; k++)
        fmpq_init(p->matrix + k);
    for (int k = 0; k < 4; k++)
        fmpq_init(p->quaternion + k);
    fmpq_set_ui(p->time, list->count - 1, 1);
    p->line = r->line;
    return p;
}

/* Where the value of a known column goes; the last row of a matrix goes nowhere. */
static fmpq *target_of(pose *p, int column) {
    if (column == TIME)
        return p->time;
    if (column < QUATERNION)
        return p->matrix + 4 * (column - POSITION) + 3;
    if (column < MATRIX)
        return p->quaternion + (column - QUATERNION);
    return column < MATRIX + 12 ? p->matrix + (column - MATRIX) : NULL;
}

static graze_status read_pose_value(const reading *r, pose *p, int column) {
    field one = field_trimmed(r->cut.item[r->place[column]]);
    fmpq_t value;
    fmpq_init(value);
    graze_status status = rational_parse(value, r->context, one.start, one.length);
    fmpq *to = target_of(p, column);
    if (status) {
        context_item(r->context, status, NULL, 0, names[column]);
        status = context_in(r->context, status, r->list->source, r->line);
    } else if (to)
        fmpq_set(to, value);
    else if (column == COLUMNS - 1 ? !fmpq_is_one(value) : !fmpq_is_zero(value))
        status =
            context_fail_in(r->context, GRAZE_EINPUT, r->list->source, r->line,
                            "%s: expected 0, 0, 0, 1 as the last row of a matrix", names[column]);
    fmpq_clear(value);
    return status;
}

static graze_status read_pose(reading *r) {
    if (r->list->count >= r->context->limits[GRAZE_LIMIT_PIECES])
        return context_limit(r->context, GRAZE_LIMIT_PIECES, "a list of poses");
    if (r->cut.count != (size_t)r->columns)
        return context_fail_in(r->context, GRAZE_EINPUT, r->list->source, r->line,
                               "the row has %zu fields; expected %d, as many as there are "
                               "names",
                               r->cut.count, r->columns);
    pose *p = append_pose(r);
    if (!p)
        return context_fail(r->context, GRAZE_ESYSTEM, "out of memory");
    graze_status status = GRAZE_OK;
    for (int k = 0; k < COLUMNS && !status; k++)
        if (r->place[k] >= 0)
            status = read_pose_value(r, p, k);
    if (!status && r->list->count > 1 && fmpq_cmp(p[-1].time, p->time) >= 0)
        status = context_fail_in(r->context, GRAZE_EINPUT, r->list->source, r->line,
                                 "the time is not after that of line %lu; expected "
                                 "increasing times",
                                 p[-1].line);
    return status;
}

/* A line that is neither blank nor a comment: the names, or a pose. */
static graze_status read_line(reading *r, int named, field line) {
    graze_status status = fields_read(&r->cut, r->context, r->list->source, r->line, line);
    if (status)
        return status;
    return named ? read_pose(r) : read_names(r);
}

static graze_status read_lines(reading *r, stream *in) {
    int named = 0;
    for (;;) {
        field line;
        graze_status status = stream_next(in, &line);
        if (status || !line.start)
            return status;
        r->line = in->line;
        while (line.length && line.start[line.length - 1] == '\r')
            line.length--; /* of CR CR LF */
        line = field_trimmed(line);
        if (!line.length || *line.start == '#')
            continue;
        status = read_line(r, named, line);
        if (status)
            return status;
        named = 1;
    }
}

graze_status poses_read(pose_list *out, graze_context *context, const char *path) {
    memset(out, 0, sizeof *out);
    out->source = path;
    char *text = NULL;
    size_t length;
    unsigned char sha256[32];
    stream in;
    reading r = {.context = context, .list = out};
    graze_status status = file_read(&text, &length, sha256, context, path);
    if (status)
        return status;
    stream_of_text(&in, context, path, text, length);
    status = read_lines(&r, &in);
    if (!status && out->count < 2)
        status = context_fail_in(context, GRAZE_EINPUT, path, 0,
                                 "has %zu poses; expected at least 2, under a line of names",
                                 out->count);
    fields_clear(&r.cut);
    free(text);
    return status;
}

void poses_clear(pose_list *list) {
    for (size_t i = 0; i < list->count; i++) {
        pose *p = list->item + i;
        fmpq_clear(p->time);
        for (int k = 0; k < 12; k++)
            fmpq_clear(p->matrix + k);
        for (int k = 0; k < 4; k++)
            fmpq_clear(p->quaternion + k);
    }
    free(list->item);
}
