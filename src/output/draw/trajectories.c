/* The panel of trajectories: lines, and arrowheads, contacts and names that do not overlap.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/views.h"

#include <math.h>
#include "base/context/scope.h"

/* The visible part of a trajectory: its beginning, its length, and the place at a given length with
 * the direction at this place. */
typedef struct seen_part {
    int any;
    double start[2], length;
    double place[2], direction[2];
} seen_part;

static seen_part see_trail(const panel *at, const trail *from, double until) {
    seen_part out = {0, {0, 0}, 0, {0, 0}, {0, 0}};
    double last[2], next[2], share[2];
    for (size_t k = 0; k < from->place_count; k++) {
        panel_map(&next[0], &next[1], at, from->at + 3 * k);
        if (k && panel_clip_segment(share, at, last, next)) {
            double d[2] = {next[0] - last[0], next[1] - last[1]};
            double length = sqrt(d[0] * d[0] + d[1] * d[1]), seen = (share[1] - share[0]) * length;
            for (int i = 0; i < 2 && !out.any; i++)
                out.start[i] = last[i] + share[0] * d[i];
            if (out.length < until && out.length + seen >= until)
                for (int i = 0; i < 2; i++) {
                    out.place[i] = last[i] + (share[0] + (until - out.length) / length) * d[i];
                    out.direction[i] = d[i];
                }
            out.any = 1;
            out.length += seen;
        }
        last[0] = next[0];
        last[1] = next[1];
    }
    if (from->place_count && !out.any) {
        out.start[0] = last[0];
        out.start[1] = last[1];
        out.any = panel_holds(at, last[0], last[1]);
    }
    return out;
}

static void span_path(drawn_path *out, const panel *at, const trail *from, const trail_span *span) {
    for (size_t k = 0; k < span->count; k++) {
        double x, y;
        panel_map(&x, &y, at, from->at + 3 * (span->first + k));
        drawn_path_to(out, k ? 'L' : 'M', x, y);
    }
}

static void draw_trail(canvas *c, const panel *at, const trail *from, labels *names) {
    for (int lines = 0; lines < 2; lines++)
        for (size_t k = 0; k < from->span_count; k++) {
            const trail_span *span = &from->span[k];
            drawn_path line = {NULL, 0, 0, 0};
            if (lines || span->state == GRAZE_STATE_B)
                span_path(&line, at, from, span);
            if (lines)
                labels_avoid_path(names, &line);
            canvas_path(c, &line,
                        !lines                         ? &trail_sliding
                        : span->state == GRAZE_STATE_I ? &trail_inside
                                                       : &trail_outside,
                        NULL);
        }
}

/* Draw an arrowhead as near to the trajectory's middle as contacts, beginnings and other arrowheads
 * permit; none if there is no room. */
static void draw_arrow(canvas *c, const panel *at, const trail *from, labels *names) {
    enum { SIZE = 9, CLEAR = 7, PLACES = 24 };
    double length = see_trail(at, from, INFINITY).length;
    for (int k = 1; k < 2 * PLACES && length > 24; k++) {
        double share = .5 + .5 * (k / 2 * (k % 2 ? 1 : -1)) / PLACES;
        seen_part spot = see_trail(at, from, share * length);
        double along = hypot(spot.direction[0], spot.direction[1]);
        double dx = spot.direction[0] * SIZE / along, dy = spot.direction[1] * SIZE / along;
        double x = spot.place[0] - dx / 2, y = spot.place[1] - dy / 2;
        if (labels_meet_mark(names, x, y, CLEAR))
            continue;
        draw_arrow_head(c, spot.place[0], spot.place[1], dx, dy, SIZE);
        labels_avoid(names, x, y, CLEAR);
        return;
    }
}

/* A mark of a contact. A slide has three marks: the middle, and its ends, which are shown if they
 * are apart from the middle. */
typedef struct seen_mark {
    int shown;
    double x, y;
    graze_kind kind;
    graze_cell_kind cell;
} seen_mark;

static void see_contact(seen_mark out[3], const panel *at, const trail_contact *met) {
    enum { APART = 9 };
    double x, y;
    panel_map(&x, &y, at, met->at);
    out[2] = (seen_mark){panel_holds(at, x, y), x, y, met->kind, met->cell};
    for (int k = 0; k < 2; k++) {
        seen_mark *m = &out[k];
        *m = (seen_mark){.cell = met->end_cell[k]};
        panel_map(&m->x, &m->y, at, met->end[k]);
        m->shown = met->lasts && panel_holds(at, m->x, m->y) && hypot(m->x - x, m->y - y) > APART;
    }
}

static void draw_contacts(canvas *c, const panel *at, const trail *from, labels *names) {
    seen_mark seen[3];
    for (size_t k = 0; k < from->contact_count; k++) {
        see_contact(seen, at, &from->contact[k]);
        for (const seen_mark *m = seen; m < seen + 3; m++)
            if (m->shown) {
                mark_contact(c, m->x, m->y, m->kind, m->cell);
                labels_avoid(names, m->x, m->y, MARK_RADIUS);
            }
    }
}

void trajectories_seen(picture *p) {
    legend *out = &p->legend;
    const panel *at = &p->trajectories;
    for (size_t k = 0; k < p->request->point_count; k++) {
        const trail *c = &p->trails[k];
        double x, y;
        panel_map(&x, &y, at, c->at);
        out->tones[c->tone] |= panel_holds(at, x, y);
        for (size_t j = 0; j < c->span_count; j++) {
            drawn_path line = {NULL, 0, 0, 0};
            span_path(&line, at, c, &c->span[j]);
            int *row = &out->spans[c->span[j].state == GRAZE_STATE_B   ? 2
                                   : c->span[j].state == GRAZE_STATE_I ? 1
                                                                       : 0];
            *row |= panel_shows(at, &line);
            p->failed |= line.failed;
            drawn_path_clear(&line);
        }
        for (size_t j = 0; j < c->contact_count; j++) {
            seen_mark seen[3];
            see_contact(seen, at, &c->contact[j]);
            for (const seen_mark *m = seen; m < seen + 3; m++)
                out->contacts[m->kind][m->cell] |= m->shown;
        }
    }
}

/* Draw a disk where the trajectory begins, if this place is in the panel. */
static void draw_start(canvas *c, const panel *at, const trail *from, labels *names) {
    double x, y;
    panel_map(&x, &y, at, from->at);
    if (!panel_holds(at, x, y))
        return;
    mark_point(c, x, y, MARK_LARGE, from->tone);
    labels_avoid(names, x, y, MARK_LARGE);
}

/* Write the name next to the place where the trajectory enters the panel, or next to a place
 * farther along it; else at a distance from one of these places. */
static void name_trail(canvas *c, const panel *at, const trail *from, const char *name,
                       labels *names) {
    static const double shares[] = {0, .12, .3, .7, .88};
    static const double reaches[] = {REACH_NEAR, REACH_FAR};
    seen_part seen = see_trail(at, from, INFINITY);
    double x, y;
    panel_map(&x, &y, at, from->at);
    int placed = !seen.any, starts = panel_holds(at, x, y);
    for (int k = 0; k < 10 && !placed; k++) {
        seen_part along = see_trail(at, from, shares[k % 5] * seen.length);
        const double *spot = k % 5 ? along.place : seen.start;
        labelled_point here = {spot[0], spot[1], starts && k % 5 == 0 ? MARK_LARGE : 0,
                               reaches[k / 5]};
        placed = (k % 5 == 0 || seen.length > 0) && labels_place(names, c, here, name);
    }
    names->left_out += !placed;
}

static graze_status draw_standing(canvas *c, graze_context *context, const picture *p) {
    const style body = {.fill = PAINT(0xe4e4e4), .stroke = PAINT(INK), .width = 1.6};
    const finish how = {0xe4e4e4, .25, 1};
    if (!picture_is_plane(p))
        return shapes_paint(c, context, &p->standing, &how, 1, &p->trajectories);
    drawn_path rings = {NULL, 0, 0, 0};
    shape_outline(&rings, &p->standing, &p->trajectories, NULL, 0);
    canvas_path(c, &rings, &body, NULL);
    return GRAZE_OK;
}

graze_status view_trajectories(canvas *c, graze_context *context, const picture *p) {
    const panel *at = &p->trajectories;
    size_t n = p->request->point_count;
    HELD(labels, names, at, !picture_is_plane(p));
    canvas_begin(c, "trajectories", NULL);
    c->kind->clip(c, at->x, at->y, at->width, at->height);
    TRY(draw_standing(c, context, p));
    for (size_t k = 0; k < n; k++) {
        draw_trail(c, at, &p->trails[k], &names);
        TRY(context_poll(context));
    }
    c->kind->unclip(c);
    for (size_t k = 0; k < n; k++)
        draw_start(c, at, &p->trails[k], &names);
    for (size_t k = 0; k < n; k++)
        draw_contacts(c, at, &p->trails[k], &names);
    for (size_t k = 0; k < n; k++)
        draw_arrow(c, at, &p->trails[k], &names);
    panel_frame(c, at, picture_is_plane(p) ? "xy" : NULL);
    for (size_t k = 0; k < n; k++) {
        name_trail(c, at, &p->trails[k], p->request->names[k], &names);
        TRY(context_poll(context));
    }
    labels_tell(&names, c);
    c->failed |= names.failed;
    canvas_end(c);
    return GRAZE_OK;
}
