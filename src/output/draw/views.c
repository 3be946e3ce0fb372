/* The panels: classes of cells, positions in space, trajectories.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/views.h"

#include <math.h>
#include "base/context/scope.h"

int picture_is_plane(const picture *p) {
    return p->scene->motion->dimension == 2;
}

static int is_unsweep(const picture *p) {
    return p->scene->options.operation == GRAZE_UNSWEEP;
}

/* Fit the panel of the cells. Each cell has a whole number of pixels, unless there are too many. */
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

static graze_status fit_panel(panel *out, graze_context *context, const projection *look,
                              const extent *all, const char *title, int numbered) {
    *out = panel_fit(look, all, 480);
    TRY(range_check(context, out->window.low, out->window.high, 2));
    panel_name(out, title, numbered);
    return GRAZE_OK;
}

/* Fit the panel of trajectories around the standing solid, since trajectories may come from far and
 * go far. */
static graze_status fit_trajectories(picture *p, graze_context *context, const projection *look) {
    extent solid = extent_empty(), all, near;
    shape_extent(&solid, &p->standing, look);
    double size = longer_side(&solid);
    all = near = solid;
    extent_grow(&near, .5 * size);
    for (size_t k = 0; k < p->request->point_count; k++)
        trail_extent(&all, &p->trails[k], look, &near);
    extent_grow(&all, .1 * size);
    return fit_panel(&p->trajectories, context, look, &all,
                     is_unsweep(p) ? "Trajectories M(t)P through S"
                                   : "Inverted trajectories M(t)⁻¹P through S",
                     picture_is_plane(p));
}

/* Append the equation of the cells' plane, unless it is long. */
static void tell_plane(text *out, const picture *p) {
    enum { LONG = 44 };
    HELD(text, plane);
    cells_plane(&plane, &p->cells, p->request->plane_axis);
    int told = !p->cells.section || plane.failed || strlen(plane.data) <= LONG;
    text_format(out, told ? " in the plane %s" : " in an oblique plane",
                plane.failed ? "" : plane.data);
    out->failed |= plane.failed;
}

static void name_classes(picture *p) {
    HELD(text, title);
    text_put(&title, p->request->by_distance
                         ? is_unsweep(p) ? "Distance to the unsweep" : "Distance to the sweep"
                     : is_unsweep(p) ? "The unsweep"
                                     : "The sweep by class");
    if (!picture_is_plane(p))
        tell_plane(&title, p);
    panel_name(&p->classes, title.failed ? "" : title.data, 1);
    p->failed |= title.failed;
}

static graze_status fit_positions(picture *p, graze_context *context, const projection *look) {
    extent all = extent_empty();
    for (size_t k = 0; k < p->request->times; k++)
        shape_extent(&all, &p->moved[k], look);
    extent_grow(&all, .06 * longer_side(&all));
    return fit_panel(&p->positions, context, look, &all,
                     "S at the start (yellow) to the end (pink)", 0);
}

graze_status views_fit(picture *p, graze_context *context) {
    projection look =
        picture_is_plane(p) ? projection_of_axes(0, 1) : projection_from(p->request->view);
    fit_classes(p);
    TRY(range_check(context, p->classes.window.low, p->classes.window.high, 2));
    name_classes(p);
    p->has_positions = !picture_is_plane(p);
    if (p->has_positions)
        TRY(fit_positions(p, context, &look));
    p->has_trajectories = p->request->point_count > 0;
    return p->has_trajectories ? fit_trajectories(p, context, &look) : GRAZE_OK;
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

/* Draw the cells. In E^3 by class, draw for each class the region of this class and all later ones,
 * over which the later ones are drawn. */
static graze_status draw_cells(canvas *c, graze_context *context, const picture *p) {
    HELD(text, layout);
    cells_attributes(&layout, &p->cells, &p->classes);
    c->failed |= layout.failed;
    canvas_begin(c, "cells", layout.failed ? NULL : layout.data);
    int regions = !p->cells.split;
    for (int k = 0; k < 2 * TONE_COUNT; k++) {
        tone t = (tone)(k % TONE_COUNT);
        int split = k >= TONE_COUNT;
        const style area = {.fill = PAINT(tone_colour(t)), .crisp = !split && !regions};
        int filled = t != TONE_NONE && t != TONE_EXTERIOR && t != TONE_OUT;
        ZEROED(drawn_path, runs);
        if (k == TONE_COUNT) {
            canvas_end(c);
            canvas_begin(c, "parts", NULL);
        }
        if (regions && !split && filled && p->legend.tones[t])
            TRY(contour_path(&runs, context, p->scene, &p->cells, &p->classes, t, 0));
        if (!regions && (split ? p->cells.parts > 1 && t != TONE_NONE : filled))
            cells_path(&runs, &p->cells, &p->classes, split ? p->cells.parts : 1, t);
        canvas_path(c, &runs, &area, tone_name(t));
    }
    canvas_end(c);
    return GRAZE_OK;
}

/* Draw the level lines of the distance, and over them the border of the set. */
static graze_status draw_levels(canvas *c, graze_context *context, const picture *p) {
    canvas_begin(c, "levels", NULL);
    for (int k = 1 - BANDS; k < BANDS; k++) {
        ZEROED(drawn_path, line);
        if (k)
            TRY(contour_path(&line, context, NULL, &p->cells, &p->classes, TONE_NONE,
                             k * p->cells.step.size));
        canvas_path(c, &line, &line_level, "level");
    }
    ZEROED(drawn_path, border);
    TRY(contour_path(&border, context, p->scene, &p->cells, &p->classes, TONE_REGULAR, 0));
    canvas_path(c, &border, &line_border, "border");
    canvas_end(c);
    return GRAZE_OK;
}

/* The outline of S at time k, in the plane of the cells. */
static drawn_path outline_path(const picture *p, size_t k) {
    drawn_path line = {NULL, 0, 0, 0};
    const section *oblique = p->cells.section;
    int axis = p->request->plane_axis;
    const double unit[3] = {axis == 0, axis == 1, axis == 2};
    const double *normal = picture_is_plane(p) ? NULL : oblique ? oblique->unit : unit;
    shape_outline(&line, &p->moved[k], &p->classes, normal,
                  oblique  ? oblique->unit_height
                  : normal ? fmpq_get_d(p->cells.low + axis)
                           : 0);
    return line;
}

static void draw_outline(canvas *c, const picture *p, size_t k, const style *s) {
    drawn_path line = outline_path(p, k);
    canvas_path(c, &line, s, NULL);
}

static int is_in_plane(const picture *p, size_t point) {
    int axis = p->request->plane_axis;
    const fmpq *at = p->request->points + point * 3;
    if (picture_is_plane(p))
        return 1;
    return p->cells.section ? section_holds(p->cells.section, at)
                            : fmpq_equal(at + axis, p->cells.low + axis);
}

/* Draw the points and their names in a panel that shows points at their places. */
static graze_status draw_points(canvas *c, graze_context *context, const picture *p,
                                const panel *at, int plane_only) {
    HELD(labels, names, at, !plane_only);
    for (int pass = 0; pass < 2; pass++)
        for (size_t k = 0; k < p->request->point_count; k++) {
            double x, y;
            panel_map(&x, &y, at, p->points + 3 * k);
            if ((plane_only && !is_in_plane(p, k)) || !panel_holds(at, x, y))
                continue;
            if (pass) {
                labelled_point here = {x, y, MARK_RADIUS, REACH_FAR};
                names.left_out += !labels_place(&names, c, here, p->request->names[k]);
                TRY(context_poll(context));
            } else {
                mark_point(c, x, y, MARK_RADIUS, p->trails[k].tone);
                labels_avoid(&names, x, y, MARK_RADIUS);
            }
        }
    labels_tell(&names, c);
    return GRAZE_OK;
}

graze_status view_classes(canvas *c, graze_context *context, const picture *p) {
    const char *axes = cells_axes(&p->cells);
    const panel *at = &p->classes;
    size_t last = p->request->times - 1;
    canvas_begin(c, "classes", NULL);
    c->kind->clip(c, at->x, at->y, at->width, at->height);
    TRY(draw_cells(c, context, p));
    if (p->request->by_distance)
        TRY(draw_levels(c, context, p));
    /* Over distances, outlines between start and end would be taken for level lines. */
    for (size_t k = 1; k < last && !p->request->by_distance; k++)
        draw_outline(c, p, k, &outline_between);
    draw_outline(c, p, last, &outline_end);
    draw_outline(c, p, 0, &outline_start);
    arcs_draw(c, p);
    c->kind->unclip(c);
    panel_frame(c, at, (const char[]){axes[p->cells.axis[0]], axes[p->cells.axis[1]]});
    TRY(draw_points(c, context, p, at, 1));
    canvas_end(c);
    return GRAZE_OK;
}

/* The rectangle of the cells, as it lies in space. */
static drawn_path plane_path(const picture *p) {
    const extent *e = &p->classes.window;
    drawn_path frame = {NULL, 0, 0, 0};
    for (int k = 0; k < 5; k++) {
        double corner[3], x, y;
        cells_corner(corner, &p->cells, k == 1 || k == 2 ? e->high[0] : e->low[0],
                     k == 2 || k == 3 ? e->high[1] : e->low[1]);
        panel_map(&x, &y, &p->positions, corner);
        drawn_path_to(&frame, k ? 'L' : 'M', x, y);
    }
    return frame;
}

/* 1 if a part of a line lies in a panel; clears the line. */
static int shows_line(picture *p, const panel *at, drawn_path line) {
    int shown = panel_shows(at, &line);
    p->failed |= line.failed;
    drawn_path_clear(&line);
    return shown;
}

static int shows_point(const picture *p, const panel *at, size_t k) {
    double x, y;
    panel_map(&x, &y, at, p->points + 3 * k);
    return panel_holds(at, x, y);
}

void views_seen(picture *p) {
    legend *out = &p->legend;
    size_t last = p->request->times - 1;
    for (size_t k = 0; k <= last; k++) {
        int *row = &out->positions[k == 0 ? 0 : k < last ? 1 : 2];
        if (!*row && (k == 0 || k == last || !p->request->by_distance))
            *row = shows_line(p, &p->classes, outline_path(p, k));
    }
    if (p->has_positions)
        out->positions[3] = shows_line(p, &p->positions, plane_path(p));
    for (size_t k = 0; k < p->request->point_count; k++)
        if ((is_in_plane(p, k) && shows_point(p, &p->classes, k)) ||
            (p->has_positions && shows_point(p, &p->positions, k)))
            out->tones[p->trails[k].tone] = 1;
}

graze_status view_positions(canvas *c, graze_context *context, const picture *p) {
    enum { MOST = 64 };
    const panel *at = &p->positions;
    finish how[MOST];
    size_t times = p->request->times, last = times - 1;
    for (size_t k = 0; k < times && k < MOST; k++)
        how[k] = (finish){0xdddddd, .7, 0};
    how[0] = (finish){0xf0e442, .15, 1};
    how[last < MOST ? last : MOST - 1] = (finish){0xcc79a7, .15, 1};
    canvas_begin(c, "positions", NULL);
    c->kind->clip(c, at->x, at->y, at->width, at->height);
    TRY(shapes_paint(c, context, p->moved, how, times, at));
    drawn_path plane = plane_path(p);
    canvas_path(c, &plane, &outline_plane, NULL);
    c->kind->unclip(c);
    panel_frame(c, at, NULL);
    TRY(draw_points(c, context, p, at, 0));
    canvas_end(c);
    return GRAZE_OK;
}
