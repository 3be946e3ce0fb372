/* Reads lists of poses.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/convert/poses_list.h"

#include "base/context/array.h"
#include "base/context/file.h"
#include "base/context/scope.h"
#include "base/number/rational.h"

enum { POSE_NUMBERS = 1 + 12 + 4 };

typedef struct reading {
    graze_context *context;
    pose_list *list;
    text *report;
    const pose_choice *choice;
    size_t capacity;
    unsigned long line;
    fields cut;     /* fields of that line */
    char separator; /* byte between fields; '\0' before the first line */
    pose_columns columns;
    fmpq *before; /* the time of the row before */
    unsigned long line_before, in_time;
    int passing; /* the last pose read is kept only if none follows */
} reading;

void pose_init(pose *p) {
    p->time = _fmpq_vec_init(POSE_NUMBERS);
    p->matrix = p->time + 1;
    p->quaternion = p->matrix + 12;
}

void pose_clear(pose *p) {
    _fmpq_vec_clear(p->time, POSE_NUMBERS);
}

static pose *append_pose(reading *r) {
    pose_list *list = r->list;
    if (!array_reserve(&list->item, &r->capacity, list->count + 1, sizeof *list->item))
        return NULL;
    pose *p = list->item + list->count++;
    pose_init(p);
    fmpq_set_ui(p->time, list->rows, 1);
    p->line = r->line;
    p->row = r->choice->numbered ? list->rows + 1 : r->line;
    return p;
}

static void drop_pose(pose_list *list) {
    pose_clear(&list->item[--list->count]);
}

/* Where the value of a known column is stored; NULL for nanoseconds, row numbers and the last row
 * of a matrix.
 */
static fmpq *target_of(pose *p, int column) {
    if (column == POSE_TIME)
        return p->time;
    if (column < POSE_QUATERNION)
        return p->matrix + 4 * (column - POSE_POSITION) + 3;
    if (column < POSE_MATRIX)
        return p->quaternion + (column - POSE_QUATERNION);
    if (column < POSE_BOTTOM)
        return p->matrix + (column - POSE_MATRIX);
    if (column < POSE_AXIS || column >= POSE_NANOSECONDS)
        return NULL;
    return p->quaternion + (column - POSE_AXIS) % 3;
}

/* Beside a column of seconds, nanoseconds must be less than one second. */
static graze_status add_nanoseconds(const reading *r, pose *p, fmpq_t value) {
    int alone = r->columns.place[POSE_TIME] < 0;
    LOCAL(fmpq, unit);
    fmpq_set_si(unit, 1, 1000000000);
    fmpq_mul(value, value, unit);
    if (!alone && (fmpq_sgn(value) < 0 || fmpq_cmp_ui(value, 1) >= 0))
        return context_fail_in(r->context, GRAZE_EINPUT, r->list->source, r->line,
                               "nanoseconds beside seconds; expected 0 to 999999999, or one of the "
                               "two columns named as the time");
    if (alone)
        fmpq_zero(p->time);
    fmpq_add(p->time, p->time, value);
    return GRAZE_OK;
}

static graze_status take_pose_row(const reading *r, pose *p, const fmpq_t value) {
    static const ulong most = 1000000000000000;
    if (!fmpz_is_one(fmpq_denref(value)) || fmpq_sgn(value) <= 0 ||
        fmpz_cmp_ui(fmpq_numref(value), most) > 0)
        return context_fail_in(r->context, GRAZE_EINPUT, r->list->source, r->line,
                               "row: expected a whole number from 1 to 10^15");
    p->row = fmpz_get_ui(fmpq_numref(value));
    return GRAZE_OK;
}

static graze_status read_pose_value(const reading *r, pose *p, int column) {
    field one = field_content(r->cut.item[r->columns.place[column]]);
    const char *name = pose_column_name(column, r->choice->naming.order);
    graze_rounding rounding = r->context->rounding;
    LOCAL(fmpq, value);
    if (column >= POSE_NANOSECONDS)
        r->context->rounding = GRAZE_ROUND_NONE;
    graze_status status = rational_parse(value, r->context, one.start, one.length);
    r->context->rounding = rounding;
    context_item(r->context, status, NULL, 0, name);
    TRY(context_in(r->context, status, r->list->source, r->line));
    fmpq *to = target_of(p, column);
    if (column == POSE_NANOSECONDS)
        return add_nanoseconds(r, p, value);
    if (column == POSE_ROW)
        return take_pose_row(r, p, value);
    if (to)
        fmpq_set(to, value);
    else if (column == POSE_AXIS - 1 ? !fmpq_is_one(value) : !fmpq_is_zero(value))
        return context_fail_in(r->context, GRAZE_EINPUT, r->list->source, r->line,
                               "%s: expected 0, 0, 0, 1 as the last row of a matrix, whose numbers "
                               "stand row by row",
                               name);
    return GRAZE_OK;
}

static graze_status read_values(reading *r, pose *p) {
    for (int k = 0; k < POSE_COLUMNS; k++)
        if (r->columns.place[k] >= 0)
            TRY(read_pose_value(r, p, k));
    if (r->line_before && fmpq_cmp(r->before, p->time) >= 0)
        return context_fail_in(r->context, GRAZE_EINPUT, r->list->source, r->line,
                               "the time is not after that of line %lu; expected increasing times",
                               r->line_before);
    for (int k = 3; k < 12; k += 4)
        fmpq_mul(p->matrix + k, p->matrix + k, r->choice->scale);
    fmpq_set(r->before, p->time);
    r->line_before = r->line;
    return GRAZE_OK;
}

/* Keep or drop the pose read last; one that `every` passes over is dropped when the next one comes,
 * so that the last one stays. */
static void choose(reading *r) {
    const pose_choice *choice = r->choice;
    pose_list *list = r->list;
    const fmpq *time = list->item[list->count - 1].time;
    if ((choice->from && fmpq_cmp(time, choice->from) < 0) ||
        (choice->to && fmpq_cmp(time, choice->to) > 0)) {
        drop_pose(list);
        return;
    }
    if (r->passing) {
        pose last = list->item[list->count - 1];
        list->item[list->count - 1] = list->item[list->count - 2];
        list->item[list->count - 2] = last;
        drop_pose(list);
    }
    r->passing = r->in_time++ % choice->every != 0;
}

static graze_status read_pose(reading *r) {
    size_t most = r->context->limits[GRAZE_LIMIT_PIECES];
    if (r->cut.count != r->columns.count)
        return context_fail_in(r->context, GRAZE_EINPUT, r->list->source, r->line,
                               "the row has %zu fields; expected %zu, as many as %s", r->cut.count,
                               r->columns.count, "on the first line");
    pose *p = append_pose(r);
    if (!p)
        return context_fail(r->context, GRAZE_ESYSTEM, "out of memory");
    r->list->rows++;
    TRY(read_values(r, p));
    choose(r);
    return r->list->count > most ? context_limit(r->context, GRAZE_LIMIT_PIECES, "a list of poses")
                                 : GRAZE_OK;
}

/* A line that is neither blank nor a comment. */
static graze_status read_line(reading *r, field line) {
    int first = !r->separator, header = 0;
    if (first)
        r->separator = field_separator(line);
    TRY(fields_read(&r->cut, r->context, r->list->source, r->line, line, r->separator));
    if (first)
        TRY(pose_columns_fix(&r->columns, &header, r->report, r->context, r->list->source, r->line,
                             &r->cut, r->separator, &r->choice->naming));
    r->list->form = r->columns.form;
    r->list->dimension = r->choice->naming.dimension;
    r->list->unit = r->columns.place[POSE_ROW] >= 0 ? "row" : r->choice->numbered ? "pose" : "line";
    return header ? GRAZE_OK : read_pose(r);
}

static graze_status read_lines(reading *r, stream *in) {
    for (;;) {
        field line;
        TRY(stream_next(in, &line));
        if (!line.start)
            return GRAZE_OK;
        r->line = in->line;
        while (line.length && line.start[line.length - 1] == '\r')
            line.length--; /* of CR CR LF */
        line = field_trimmed(line);
        if (!line.length || *line.start == '#')
            continue;
        TRY(read_line(r, line));
    }
}

static graze_status read_pose_text(reading *r, const char *text, size_t length) {
    stream in;
    stream_of_text(&in, r->context, r->list->source, text, length);
    graze_status status = read_lines(r, &in);
    if (!status && r->list->count < 2)
        status = context_fail_in(r->context, GRAZE_EINPUT, r->list->source, 0,
                                 r->list->rows < 2 ? "has %zu poses; expected at least 2"
                                                   : "%zu poses are left; expected at least 2",
                                 r->list->count);
    fields_clear(&r->cut);
    return status;
}

graze_status poses_read(pose_list *out, text *report, graze_context *context, const char *path,
                        const pose_choice *choice) {
    out->source = path;
    FREED(char, text, NULL);
    size_t length = choice->length;
    unsigned char sha256[32];
    LOCAL(fmpq, before);
    reading r = {
        .context = context, .list = out, .report = report, .choice = choice, .before = before};
    if (!choice->text)
        TRY(file_read(&text, &length, sha256, context, path));
    return read_pose_text(&r, choice->text ? choice->text : text, length);
}

void pose_list_clear(pose_list *list) {
    while (list->count)
        drop_pose(list);
    free(list->item);
}
