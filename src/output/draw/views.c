/* The panels: classes of cells, positions in space, trajectories.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/views.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "output/draw/cell_parts.h"
#include "output/draw/labels.h"
#include "output/draw/levels.h"
#include "output/draw/range.h"
#include "output/draw/shape_paint.h"
#include "output/report/decimal_time.h"

static int is_plane(const picture *p) {
    return p->scene->motion->dimension == 2;
}

static int is_unsweep(const picture *p) {
    return p->scene->options.operation == GRAZE_UNSWEEP;
}

/* The panel of the cells: a whole number of pixels for each, where they are not too many. */
static void fit_classes(picture *p) {
    const size_t *count = p->cells.count;
    size_t longer = count[0] > count[1] ? count[0] : count[1];
    double wanted = (double)count[0] > CELLS_WIDE * (double)count[1] ? 720 : 480;
    double cell = fmax(round(wanted / (double)longer), 1);
    panel *at = &p->classes;
    at->look = p->cells.section ? p->cells.section->look
                                : projection_of_axes(p->cells.axis[0], p->cells.axis[1]);
    at->window = cells_extent(&p->cells);
    at->width = cell * (double)count[0];
    at->height = cell * (double)count[1];
    at->scale = at->width / (at->window.high[0] - at->window.low[0]);
}

static double longer_side(const extent *e) {
    return fmax(e->high[0] - e->low[0], e->high[1] - e->low[1]);
}

/* Around the standing solid; trajectories may come from far and go far. */
static graze_status fit_trajectories(picture *p, graze_context *context, const projection *look) {
    extent solid = extent_empty(), all, near;
    shape_extent(&solid, &p->standing, look);
    double size = longer_side(&solid);
    all = near = solid;
    extent_grow(&near, .5 * size);
    for (size_t k = 0; k < p->request->point_count; k++)
        trail_extent(&all, &p->trails[k], look, &near);
    extent_grow(&all, .1 * size);
    p->trajectories = panel_fit(look, &all, 480);
    graze_status status =
        range_check(context, p->trajectories.window.low, p->trajectories.window.high, 2);
    if (!status)
        panel_name(&p->trajectories,
                   is_unsweep(p) ? "Trajectories M(t)P through S"
                                 : "Inverted trajectories M(t)⁻¹P through S",
                   is_plane(p));
    return status;
}

/* The plane of the cells: a long ratio as a decimal, marked where that is not the number itself. */
static void tell_axis_plane(char *out, size_t size, const picture *p) {
    enum { LONG = 13 }; /* 12 digits and the bar */
    int axis = p->request->plane_axis, exact = 1;
    char *ratio = fmpq_get_str(NULL, 10, p->cells.low + axis), *shorter = NULL;
    if (strlen(ratio) > LONG)
        shorter = decimal_of_rational(&exact, p->cells.low + axis, 10);
    snprintf(out, size, " in the plane %c %s %s", "xyz"[axis], exact ? "=" : "≈",
             shorter ? shorter : ratio);
    flint_free(ratio);
    free(shorter);
}

/* An equation that is long is left out of the title. */
static void tell_section(char *out, size_t size, const picture *p) {
    enum { LONG = 44 };
    text equation;
    text_init(&equation);
    section_equation(&equation, p->cells.section);
    if (equation.failed || strlen(equation.data) > LONG)
        snprintf(out, size, " in an oblique plane");
    else
        snprintf(out, size, " in the plane %s", equation.data);
    text_clear(&equation);
}

static void name_classes(picture *p) {
    const char *what = p->request->by_distance
                           ? is_unsweep(p) ? "Distance to the unsweep" : "Distance to the sweep"
                       : is_unsweep(p) ? "The unsweep"
                                       : "The sweep by class";
    char title[sizeof p->classes.title];
    int length = snprintf(title, sizeof title, "%s", what);
    if (!is_plane(p))
        (p->cells.section ? tell_section : tell_axis_plane)(title + length,
                                                            sizeof title - (size_t)length, p);
    panel_name(&p->classes, title, 1);
}

static graze_status fit_positions(picture *p, graze_context *context, const projection *look) {
    extent all = extent_empty();
    for (size_t k = 0; k < p->request->times; k++)
        shape_extent(&all, &p->moved[k], look);
    extent_grow(&all, .06 * longer_side(&all));
    p->positions = panel_fit(look, &all, 480);
    graze_status status =
        range_check(context, p->positions.window.low, p->positions.window.high, 2);
    if (!status)
        panel_name(&p->positions, "S at the start (yellow) to the end (pink)", 0);
    return status;
}

graze_status views_fit(picture *p, graze_context *context) {
    projection look = is_plane(p) ? projection_of_axes(0, 1) : projection_from(p->request->view);
    fit_classes(p);
    graze_status status = range_check(context, p->classes.window.low, p->classes.window.high, 2);
    if (status)
        return status;
    name_classes(p);
    p->has_positions = !is_plane(p);
    if (p->has_positions)
        status = fit_positions(p, context, &look);
    p->has_trajectories = p->request->point_count > 0;
    if (!status && p->has_trajectories)
        status = fit_trajectories(p, context, &look);
    return status;
}

size_t views_outside(const picture *p) {
    const panel *at = p->has_positions ? &p->positions : &p->classes;
    size_t outside = 0;
    for (size_t k = 0; k < p->request->point_count; k++) {
        double place[2];
        for (int i = 0; i < 2; i++)
            place[i] = projection_at(&at->look, i, p->points + 3 * k);
        outside += place[0] < at->window.low[0] || place[0] > at->window.high[0] ||
                   place[1] < at->window.low[1] || place[1] > at->window.high[1];
    }
    return outside;
}

static void draw_cells(canvas *c, const picture *p) {
    text layout;
    text_init(&layout);
    cells_attributes(&layout, &p->cells, &p->classes);
    c->failed |= layout.failed;
    canvas_begin(c, "cells", layout.failed ? NULL : layout.data);
    text_clear(&layout);
    for (int t = TONE_REGULAR; t < TONE_COUNT; t++) {
        const style area = {.fill = PAINT(tone_colour((tone)t)), .crisp = 1};
        drawn_path runs = {NULL, 0, 0, 0};
        if (t != TONE_EXTERIOR && t != TONE_OUT)
            cells_path(&runs, &p->cells, &p->classes, (tone)t);
        canvas_path(c, &runs, &area, tone_name((tone)t));
        drawn_path_clear(&runs);
    }
    canvas_end(c);
    canvas_begin(c, "parts", NULL);
    for (int t = TONE_REGULAR; t < TONE_COUNT; t++) {
        const style area = {.fill = PAINT(tone_colour((tone)t))};
        drawn_path runs = {NULL, 0, 0, 0};
        parts_path(&runs, &p->cells, &p->classes, (tone)t);
        canvas_path(c, &runs, &area, tone_name((tone)t));
        drawn_path_clear(&runs);
    }
    canvas_end(c);
}

/* Level lines of the distance, and over them the borders between cells of different answers. */
static void draw_levels(canvas *c, const picture *p) {
    canvas_begin(c, "levels", NULL);
    for (int k = 1 - BANDS; k < BANDS; k++) {
        drawn_path line = {NULL, 0, 0, 0};
        if (k)
            level_path(&line, &p->cells, &p->classes, k);
        canvas_path(c, &line, &line_level, "level");
        drawn_path_clear(&line);
    }
    drawn_path border = {NULL, 0, 0, 0};
    border_path(&border, &p->cells, &p->classes);
    canvas_path(c, &border, &line_border, "border");
    drawn_path_clear(&border);
    canvas_end(c);
}

static void draw_outline(canvas *c, const picture *p, size_t k, const style *s) {
    drawn_path line = {NULL, 0, 0, 0};
    const section *oblique = p->cells.section;
    double normal[3] = {0, 0, 0};
    int axis = p->request->plane_axis;
    normal[axis] = 1;
    if (is_plane(p))
        shape_rings(&line, &p->moved[k], &p->classes);
    else if (oblique)
        shape_slice(&line, &p->moved[k], &p->classes, oblique->unit, oblique->unit_height);
    else
        shape_slice(&line, &p->moved[k], &p->classes, normal, fmpq_get_d(p->cells.low + axis));
    canvas_path(c, &line, s, NULL);
    drawn_path_clear(&line);
}

static int is_in_plane(const picture *p, size_t point) {
    int axis = p->request->plane_axis;
    const fmpq *at = p->request->points + point * 3;
    if (is_plane(p))
        return 1;
    return p->cells.section ? section_holds(p->cells.section, at)
                            : fmpq_equal(at + axis, p->cells.low + axis);
}

static int is_in_window(const panel *p, double x, double y) {
    return x >= p->x && y >= p->y && x <= p->x + p->width && y <= p->y + p->height;
}

/* The points of a panel that shows them where they are, and their names. */
static graze_status draw_points(canvas *c, graze_context *context, const picture *p,
                                const panel *at, int plane_only) {
    graze_status status = GRAZE_OK;
    labels names;
    labels_init(&names, at);
    for (int pass = 0; pass < 2; pass++)
        for (size_t k = 0; k < p->request->point_count && !status; k++) {
            double x, y;
            panel_map(&x, &y, at, p->points + 3 * k);
            if ((plane_only && !is_in_plane(p, k)) || !is_in_window(at, x, y))
                continue;
            if (pass) {
                labelled_point here = {x, y, MARK_RADIUS, REACH_FAR};
                names.left_out += !labels_place(&names, c, here, p->request->names[k]);
                status = context_poll(context);
            } else {
                mark_point(c, x, y, MARK_RADIUS, p->trails[k].tone);
                labels_avoid(&names, x, y, MARK_RADIUS);
            }
        }
    labels_tell(&names, c);
    labels_clear(&names);
    return status;
}

graze_status view_classes(canvas *c, graze_context *context, const picture *p) {
    const char *axes = cells_axes(&p->cells);
    const panel *at = &p->classes;
    size_t last = p->request->times - 1;
    canvas_begin(c, "classes", NULL);
    canvas_clip(c, at->x, at->y, at->width, at->height);
    draw_cells(c, p);
    if (p->request->by_distance)
        draw_levels(c, p);
    /* They would be taken for level lines. */
    for (size_t k = 1; k < last && !p->request->by_distance; k++)
        draw_outline(c, p, k, &outline_between);
    draw_outline(c, p, last, &outline_end);
    draw_outline(c, p, 0, &outline_start);
    canvas_unclip(c);
    panel_frame(c, at);
    panel_ticks(c, at, axes[p->cells.axis[0]], axes[p->cells.axis[1]]);
    graze_status status = draw_points(c, context, p, at, 1);
    canvas_end(c);
    return status;
}

/* The rectangle of the cells, as it lies in space. */
static void draw_plane(canvas *c, const picture *p) {
    const extent *e = &p->classes.window;
    drawn_path frame = {NULL, 0, 0, 0};
    for (int k = 0; k < 4; k++) {
        double corner[3], x, y;
        cells_corner(corner, &p->cells, k == 1 || k == 2 ? e->high[0] : e->low[0],
                     k >= 2 ? e->high[1] : e->low[1]);
        panel_map(&x, &y, &p->positions, corner);
        drawn_path_to(&frame, k ? 'L' : 'M', x, y);
    }
    drawn_path_to(&frame, 'z', 0, 0);
    canvas_path(c, &frame, &outline_plane, NULL);
    drawn_path_clear(&frame);
}

graze_status view_positions(canvas *c, graze_context *context, const picture *p) {
    enum { MOST = 64 };
    const panel *at = &p->positions;
    finish how[MOST];
    graze_status status = GRAZE_OK;
    size_t times = p->request->times, last = times - 1;
    for (size_t k = 0; k < times && k < MOST; k++)
        how[k] = (finish){0xdddddd, .7, 0};
    how[0] = (finish){0xf0e442, .15, 1};
    how[last < MOST ? last : MOST - 1] = (finish){0xcc79a7, .15, 1};
    canvas_begin(c, "positions", NULL);
    canvas_clip(c, at->x, at->y, at->width, at->height);
    status = shapes_paint(c, context, p->moved, how, times, at);
    draw_plane(c, p);
    canvas_unclip(c);
    panel_frame(c, at);
    panel_triad(c, at);
    panel_scale_bar(c, at);
    if (!status)
        status = draw_points(c, context, p, at, 0);
    canvas_end(c);
    return status;
}

/* The visible part of a trajectory: its beginning, and the place after a length with the direction
 * there. */
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
        out.any = is_in_window(at, last[0], last[1]);
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
            span_path(&line, at, from, span);
            if (!lines && span->state == GRAZE_STATE_B)
                canvas_path(c, &line, &trail_sliding, NULL);
            if (lines)
                canvas_path(c, &line, span->state == GRAZE_STATE_I ? &trail_inside : &trail_outside,
                            NULL);
            if (lines)
                labels_avoid_path(names, &line);
            drawn_path_clear(&line);
        }
    double half = see_trail(at, from, INFINITY).length / 2;
    if (half > 12) {
        seen_part middle = see_trail(at, from, half);
        draw_arrow_head(c, middle.place[0], middle.place[1], middle.direction[0],
                        middle.direction[1], 9);
    }
}

static void draw_contacts(canvas *c, const panel *at, const trail *from, labels *names) {
    for (size_t k = 0; k < from->contact_count; k++) {
        const trail_contact *met = &from->contact[k];
        double x, y;
        panel_map(&x, &y, at, met->at);
        if (!is_in_window(at, x, y))
            continue;
        mark_contact(c, x, y, met->kind, met->cell);
        labels_avoid(names, x, y, MARK_RADIUS);
    }
}

/* The disk stands where the trajectory begins, if that is to be seen. */
static void draw_start(canvas *c, const panel *at, const trail *from, labels *names) {
    double x, y;
    panel_map(&x, &y, at, from->at);
    if (!is_in_window(at, x, y))
        return;
    mark_point(c, x, y, MARK_LARGE, from->tone);
    labels_avoid(names, x, y, MARK_LARGE);
}

/* A name next to where the trajectory comes into sight or next to it farther along; else at a
 * distance from one of these places. */
static void name_trail(canvas *c, const panel *at, const trail *from, const char *name,
                       labels *names) {
    static const double shares[] = {0, .12, .3, .7, .88};
    static const double reaches[] = {REACH_NEAR, REACH_FAR};
    seen_part seen = see_trail(at, from, INFINITY);
    double x, y;
    panel_map(&x, &y, at, from->at);
    int placed = !seen.any, starts = is_in_window(at, x, y);
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
    if (!is_plane(p))
        return shapes_paint(c, context, &p->standing, &how, 1, &p->trajectories);
    drawn_path rings = {NULL, 0, 0, 0};
    shape_rings(&rings, &p->standing, &p->trajectories);
    canvas_path(c, &rings, &body, NULL);
    drawn_path_clear(&rings);
    return GRAZE_OK;
}

graze_status view_trajectories(canvas *c, graze_context *context, const picture *p) {
    const panel *at = &p->trajectories;
    size_t n = p->request->point_count;
    labels names;
    labels_init(&names, at);
    canvas_begin(c, "trajectories", NULL);
    canvas_clip(c, at->x, at->y, at->width, at->height);
    graze_status status = draw_standing(c, context, p);
    for (size_t k = 0; k < n && !status; k++) {
        draw_trail(c, at, &p->trails[k], &names);
        status = context_poll(context);
    }
    canvas_unclip(c);
    for (size_t k = 0; k < n; k++)
        draw_start(c, at, &p->trails[k], &names);
    for (size_t k = 0; k < n; k++)
        draw_contacts(c, at, &p->trails[k], &names);
    panel_frame(c, at);
    if (is_plane(p)) {
        panel_ticks(c, at, 'x', 'y');
    } else {
        panel_triad(c, at);
        panel_scale_bar(c, at);
    }
    for (size_t k = 0; k < n && !status; k++) {
        name_trail(c, at, &p->trails[k], p->request->names[k], &names);
        status = context_poll(context);
    }
    labels_tell(&names, c);
    labels_clear(&names);
    canvas_end(c);
    return status;
}
