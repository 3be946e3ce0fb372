/* The stages of a picture: its contents are made exactly, then the panels are laid out and drawn.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/views.h"

#include <math.h>
#include "base/context/scope.h"

/* Make the positions of S at times spread evenly over the motion, both ends included. */
static graze_status make_positions(picture *p, graze_context *context) {
    const graze_motion *motion = p->scene->motion;
    const graze_solid *solid = p->scene->solid->curved ? &p->made : p->scene->solid;
    unsigned long n = p->request->times;
    TRY(MAKE_ARRAY(context, p->moved, n, "a picture"));
    if (p->scene->solid->curved)
        TRY(eye_solid_make(&p->made, context, p->scene->solid->curved));
    TRY(shape_standing(&p->standing, context, solid));
    LOCAL_VEC(fmpq, t, 2);
    fmpq *step = t + 1;
    fmpq_sub(step, motion->piece[motion->piece_count - 1].hi, motion->piece[0].lo);
    for (unsigned long k = 0; k < n; k++) {
        fmpq_set_ui(t, k, n - 1);
        fmpq_mul(t, t, step);
        fmpq_add(t, t, motion->piece[0].lo);
        TRY(shape_moved(&p->moved[k], context, solid, motion, t,
                        p->scene->options.operation == GRAZE_UNSWEEP));
        TRY(context_poll(context));
    }
    return GRAZE_OK;
}

static graze_status make_trails(picture *p, graze_context *context) {
    const draw_request *request = p->request;
    size_t d = (size_t)p->scene->motion->dimension;
    projection plane = projection_of_axes(0, 1), side = projection_of_axes(1, 2);
    extent solid = extent_empty();
    shape_extent(&solid, &p->standing, &plane);
    shape_extent(&solid, &p->standing, &side);
    double fineness = fmax(solid.high[0] - solid.low[0], solid.high[1] - solid.low[1]) / 2000;
    TRY(MAKE_ARRAY(context, p->trails, request->point_count + 1, "a picture"));
    TRY(MAKE_ARRAY(context, p->points, 3 * (request->point_count + 1), "a picture"));
    for (size_t k = 0; k < request->point_count; k++) {
        const fmpq *point = request->points + k * d;
        for (size_t i = 0; i < d; i++)
            p->points[3 * k + i] = fmpq_get_d(point + i);
        TRY(trail_make(&p->trails[k], context, p->scene, point, fineness));
        TRY(context_poll(context));
    }
    return GRAZE_OK;
}

/* Collect the signs that the legend explains. */
static graze_status make_legend(picture *p, graze_context *context) {
    size_t count = p->cells.count[0] * p->cells.count[1];
    legend *l = &p->legend;
    for (size_t k = 0; k < count; k++) {
        l->tones[p->cells.tone[k]] = 1;
        p->undecided += p->cells.tone[k] == TONE_NONE;
    }
    count = p->cells.split_count * p->cells.parts * p->cells.parts;
    for (size_t k = 0; k < count; k++)
        l->tones[p->cells.part[k]] = 1;
    l->cells = p->request->by_distance ? &p->cells : NULL;
    views_seen(p);
    if (p->has_trajectories)
        trajectories_seen(p);
    return p->failed ? context_fail(context, GRAZE_ESYSTEM, "out of memory for a picture")
                     : GRAZE_OK;
}

/* Places of the parts of a picture: panels in rows from the left, the legend on their right. */
typedef struct layout {
    double width, height, x, y, row, legend_x;
} layout;

enum { MARGIN = 18, HEAD = 52, WIDEST = 1130 };

static void place_panel(layout *l, panel *p) {
    double width = p->left + panel_span(p), height = PANEL_ABOVE + p->height + PANEL_BELOW;
    if (l->x > MARGIN && l->x + width > WIDEST) {
        l->x = MARGIN;
        l->y += l->row;
        l->row = 0;
    }
    p->x = l->x + p->left;
    p->y = l->y + PANEL_ABOVE;
    l->x += width + MARGIN;
    l->row = fmax(l->row, height);
    l->legend_x = fmax(l->legend_x, l->x);
}

static layout lay_out(picture *p, const char *title, const char *remark) {
    layout l = {0, 0, MARGIN, HEAD, 0, 0};
    place_panel(&l, &p->classes);
    if (p->has_positions)
        place_panel(&l, &p->positions);
    if (p->has_trajectories)
        place_panel(&l, &p->trajectories);
    l.width = l.legend_x + LEGEND_WIDTH;
    l.width = fmax(l.width, 2 * MARGIN + canvas_text_width(title, 17));
    l.width = ceil(fmax(l.width, 2 * MARGIN + canvas_text_width(remark, 12)));
    l.height = fmax(l.y + l.row, HEAD + PANEL_ABOVE + legend_height(&p->legend));
    l.height = ceil(l.height + MARGIN / 2);
    return l;
}

static graze_status draw_panels(canvas *c, graze_context *context, picture *p) {
    TRY(view_classes(c, context, p));
    if (p->has_positions)
        TRY(view_positions(c, context, p));
    if (p->has_trajectories)
        TRY(view_trajectories(c, context, p));
    return GRAZE_OK;
}

/* Append one line on the picture's cells and on what the picture leaves out. */
static void put_remark(text *out, const picture *p) {
    const cells *c = &p->cells;
    size_t outside = views_outside(p);
    text_format(out, "%zu × %zu %s", c->count[0], c->count[1], c->split ? "cells" : "points");
    if (c->split_count)
        text_format(out, ", at borders in %zu × %zu parts", c->parts, c->parts);
    text_put(out, !c->split ? " in their exact classes, contours bisected exactly"
                  : p->request->by_distance
                      ? ", each coloured by the exact side and the distance of its centre"
                      : ", each in the exact class of its centre");
    if (c->section)
        section_describe(out, c->section, 0);
    if (p->undecided)
        text_format(out, " · undecided and blank: %zu", p->undecided);
    if (outside)
        text_format(out, " · %zu of %zu points outside the picture", outside,
                    p->request->point_count);
    text_put(out,
             p->scene->solid->curved ? " · S is drawn as an approximation made for the eye" : "");
    text_put(out, " · graze " GRAZE_VERSION);
}

static graze_status draw_all(picture *p, graze_context *context, const char *file) {
    const lettering heading = {.size = 16, .bold = 1}, plain = {.size = 11};
    const char *title = p->request->title ? p->request->title : "";
    HELD(text, says);
    put_remark(&says, p);
    const char *remark = says.failed ? "" : says.data;
    layout l = lay_out(p, title, remark);
    canvas *c;
    TRY(canvas_create(&c, context, file, l.width, l.height));
    canvas_text(c, MARGIN, 26, &heading, title);
    canvas_text(c, MARGIN, 44, &plain, remark);
    c->failed |= says.failed;
    graze_status status = draw_panels(c, context, p);
    canvas_begin(c, "legend", NULL);
    legend_draw(c, &p->legend, l.legend_x, HEAD + PANEL_ABOVE);
    canvas_end(c);
    return canvas_finish(c, context, file, status);
}

static graze_status make_picture(picture *p, graze_context *context, const char *file) {
    TRY(canvas_check(context, file));
    TRY(request_cells(&p->cells, &p->section, context, p->scene, p->request));
    if (picture_is_plane(p) || p->request->by_distance)
        TRY(parts_classify(&p->cells, context, p->scene));
    TRY(make_positions(p, context));
    TRY(make_trails(p, context));
    TRY(views_fit(p, context));
    TRY(arcs_make(p, context));
    TRY(make_legend(p, context));
    return draw_all(p, context, file);
}

graze_status draw_picture(graze_context *context, const graze_scene *scene, const char *file,
                          const draw_request *request) {
    picture p = {.scene = scene, .request = request};
    graze_status status = make_picture(&p, context, file);
    for (size_t k = 0; k < request->times && p.moved; k++)
        shape_clear(&p.moved[k]);
    shape_clear(&p.standing);
    eye_solid_clear(&p.made);
    for (size_t k = 0; k < request->point_count && p.trails; k++)
        trail_clear(&p.trails[k]);
    free(p.moved);
    free(p.trails);
    free(p.points);
    arcs_clear(&p);
    section_clear(&p.section);
    cells_clear(&p.cells);
    return status;
}
