/* The first and the last time at which a point is in the closed solid.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The times at which a trajectory is in the closed solid are a union of closed intervals, whose
 * ends are ends of contacts or of the motion. The first time is t0 if the state at t0 is I or B,
 * else the beginning of the first contact; the last time is t1 or the end of the last contact.
 */
#include "output/report/row_parts.h"

#include "base/context/scope.h"

enum { NEAR_DIGITS = 17 };

static size_t last_piece(const graze_time *time) {
    return time->piece + (time_is_piece_end(time) && !time_is_end(time));
}

graze_status inside_find(row *r, graze_context *context) {
    const graze_motion *motion = r->scene->motion;
    const graze_trace *trace = r->trace;
    inside_times *out = &r->inside;
    const contact *c = trace->contact;
    size_t count = trace->contact_count, last = motion->piece_count - 1;
    *out = (inside_times){.undecided = trace->undecided != NULL};
    if (out->undecided)
        return GRAZE_OK;
    if (trace->first == GRAZE_STATE_I)
        out->end[0] = (inside_end){.end = motion->piece[0].lo};
    else if (count)
        out->end[0] = (inside_end){.time = c[0].from, .piece = time_first_piece(c[0].from)};
    if (trace->last == GRAZE_STATE_I)
        out->end[1] = (inside_end){.end = motion->piece[last].hi, .piece = last};
    else if (count)
        out->end[1] = (inside_end){.time = c[count - 1].to, .piece = last_piece(c[count - 1].to)};
    if (out->end[0].time)
        TRY(time_canonicalise(c[0].from, context));
    return out->end[1].time ? time_canonicalise(c[count - 1].to, context) : GRAZE_OK;
}

static int is_never(const inside_end *m) {
    return !m->end && !m->time;
}

static void put_inside_end(text *out, const inside_end *m, const graze_motion *motion) {
    unsigned long row = motion->piece[m->piece].row;
    text_put(out, ",");
    if (m->end) {
        text_rational(out, m->end);
        text_put(out, ",");
        text_owned(out, decimal_of_rational(NULL, m->end, NEAR_DIGITS));
    } else {
        report_put_time_near(out, m->time);
    }
    text_put(out, ",");
    if (!is_never(m))
        text_count(out, m->piece);
    if (motion->has_rows)
        text_put(out, ",");
    if (!is_never(m) && row)
        text_count(out, row);
}

void inside_csv(text *out, const row *r) {
    const graze_motion *motion = r->scene->motion;
    if (r->inside.undecided) {
        text_put(out, motion->has_rows ? ",undecided,,,,undecided,,," : ",undecided,,,undecided,,");
        return;
    }
    for (int k = 0; k < 2; k++)
        put_inside_end(out, &r->inside.end[k], motion);
}

static void json_inside_end(json_writer *w, const char *const keys[3], const inside_end *m,
                            const graze_motion *motion) {
    unsigned long row = motion->piece[m->piece].row;
    if (m->end)
        json_rational(w, keys[0], m->end);
    else
        json_time(w, keys[0], m->time);
    json_index(w, keys[1], !is_never(m), m->piece);
    if (motion->has_rows)
        json_index(w, keys[2], !is_never(m) && row, row);
}

void inside_json(json_writer *w, const row *r) {
    static const char *const keys[2][3] = {{"first", "first_piece", "first_row"},
                                           {"last", "last_piece", "last_row"}};
    for (int k = 0; k < 2; k++)
        if (r->inside.undecided)
            json_text(w, keys[k][0], "undecided");
        else
            json_inside_end(w, keys[k], &r->inside.end[k], r->scene->motion);
}
