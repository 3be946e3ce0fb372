/* The stages of a picture: its contents are made exactly, then the panels are laid out and drawn.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/draw.h"

#include <flint/fmpq_vec.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "decide/scene/box.h"
#include "output/draw/levels.h"
#include "output/draw/picture_kind.h"
#include "output/draw/views.h"

/* The scene's box with a margin of 1/16 of its longest side. */
static graze_status roomy_box(fmpq *low, fmpq *high, graze_context *context,
                              const graze_scene *scene) {
    int d = scene->motion->dimension;
    graze_status status = scene_box(low, high, context, scene);
    fmpq_t margin, side;
    fmpq_init(margin);
    fmpq_init(side);
    for (int k = 0; k < d; k++) {
        fmpq_sub(side, high + k, low + k);
        if (fmpq_cmp(side, margin) > 0)
            fmpq_set(margin, side);
    }
    fmpq_div_2exp(margin, margin, 4);
    for (int k = 0; k < d; k++) {
        fmpq_sub(low + k, low + k, margin);
        fmpq_add(high + k, high + k, margin);
    }
    fmpq_clear(margin);
    fmpq_clear(side);
    return status;
}

/* The cells of an oblique plane: u and v are their axes. */
static graze_status lay_out_section(picture *p, graze_context *context, const fmpq *low,
                                    const fmpq *high) {
    static const int axis[2] = {0, 1};
    const draw_request *request = p->request;
    fmpq *least = _fmpq_vec_init(2), *most = _fmpq_vec_init(2), *middle = _fmpq_vec_init(3);
    fmpq_t place;
    fmpq_init(place);
    for (int k = 0; k < 3; k++) {
        fmpq_add(middle + k, low + k, high + k);
        fmpq_div_2exp(middle + k, middle + k, 1);
    }
    _fmpq_vec_dot(place, request->normal, middle, 3);
    if (request->plane)
        fmpq_set(place, request->plane);
    section_make(&p->section, request->normal, place);
    graze_status status = GRAZE_OK;
    if (!section_extent(least, most, &p->section, low, high))
        status = context_fail(context, GRAZE_EUSE, "the plane does not pass through the box");
    fmpq_zero(place);
    if (!status)
        status = cells_layout(&p->cells, context, 2, axis, least, most, place, request->grid,
                              request->by_distance);
    p->cells.section = &p->section;
    fmpq_clear(place);
    _fmpq_vec_clear(least, 2);
    _fmpq_vec_clear(most, 2);
    _fmpq_vec_clear(middle, 3);
    return status;
}

static graze_status lay_out_cells(picture *p, graze_context *context, const fmpq *low,
                                  const fmpq *high) {
    const draw_request *request = p->request;
    int d = p->scene->motion->dimension, axis[2] = {0, 1};
    fmpq_t place;
    fmpq_init(place);
    if (d == 3) {
        axis[0] = request->plane_axis == 0;
        axis[1] = request->plane_axis == 2 ? 1 : 2;
        fmpq_add(place, low + request->plane_axis, high + request->plane_axis);
        fmpq_div_2exp(place, place, 1);
        if (request->plane)
            fmpq_set(place, request->plane);
    }
    graze_status status = cells_layout(&p->cells, context, d, axis, low, high, place, request->grid,
                                       request->by_distance);
    fmpq_clear(place);
    return status;
}

/* Lay out and classify the cells. */
static graze_status make_cells(picture *p, graze_context *context) {
    const draw_request *request = p->request;
    int d = p->scene->motion->dimension;
    fmpq *low = _fmpq_vec_init(d), *high = _fmpq_vec_init(d);
    graze_status status = GRAZE_OK;
    if (!request->low)
        status = roomy_box(low, high, context, p->scene);
    for (int k = 0; k < d && request->low; k++) {
        fmpq_set(low + k, request->low + k);
        fmpq_set(high + k, request->high + k);
    }
    if (!status)
        status = (request->normal ? lay_out_section : lay_out_cells)(p, context, low, high);
    _fmpq_vec_clear(low, d);
    _fmpq_vec_clear(high, d);
    if (status)
        return status;
    return request->by_distance ? cells_measure(&p->cells, context, p->scene)
                                : cells_classify(&p->cells, context, p->scene);
}

/* S at times spread evenly over the motion, both ends included. */
static graze_status make_positions(picture *p, graze_context *context) {
    const graze_motion *motion = p->scene->motion;
    unsigned long n = p->request->times;
    fmpq_t t, step;
    p->moved = calloc(n, sizeof *p->moved);
    if (!p->moved)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a picture");
    graze_status status = shape_standing(&p->standing, context, p->scene->solid);
    fmpq_init(t);
    fmpq_init(step);
    fmpq_sub(step, motion->piece[motion->piece_count - 1].hi, motion->piece[0].lo);
    for (unsigned long k = 0; k < n && !status; k++) {
        fmpq_set_ui(t, k, n - 1);
        fmpq_mul(t, t, step);
        fmpq_add(t, t, motion->piece[0].lo);
        status = shape_moved(&p->moved[k], context, p->scene->solid, motion, t,
                             p->scene->options.operation == GRAZE_UNSWEEP);
        if (!status)
            status = context_poll(context);
    }
    fmpq_clear(t);
    fmpq_clear(step);
    return status;
}

static graze_status make_trails(picture *p, graze_context *context) {
    const draw_request *request = p->request;
    size_t d = (size_t)p->scene->motion->dimension;
    projection plane = projection_of_axes(0, 1), side = projection_of_axes(1, 2);
    extent solid = extent_empty();
    shape_extent(&solid, &p->standing, &plane);
    shape_extent(&solid, &p->standing, &side);
    double fineness = fmax(solid.high[0] - solid.low[0], solid.high[1] - solid.low[1]) / 2000;
    p->trails = calloc(request->point_count + 1, sizeof *p->trails);
    p->points = calloc(request->point_count + 1, 3 * sizeof *p->points);
    if (!p->trails || !p->points)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a picture");
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < request->point_count && !status; k++) {
        const fmpq *point = request->points + k * d;
        for (size_t i = 0; i < d; i++)
            p->points[3 * k + i] = fmpq_get_d(point + i);
        status = trail_make(&p->trails[k], context, p->scene, point, fineness);
        if (!status)
            status = context_poll(context);
    }
    return status;
}

/* Collect the signs that the legend explains. */
static graze_status make_legend(picture *p, graze_context *context) {
    int made = 1;
    size_t count = p->cells.count[0] * p->cells.count[1];
    legend *l = &p->legend;
    for (size_t k = 0; k < count; k++)
        l->tones[p->cells.tone[k]] = 1;
    l->by_distance = p->request->by_distance;
    for (int t = TONE_INNER; l->by_distance && t < TONE_COUNT; t++)
        made &= band_text(l->band[t - TONE_INNER], &p->cells, (tone)t);
    l->plane = p->scene->motion->dimension == 3;
    l->trails = p->request->point_count > 0;
    for (size_t k = 0; k < p->request->point_count; k++) {
        const trail *c = &p->trails[k];
        l->tones[c->tone] = 1;
        for (size_t j = 0; j < c->contact_count; j++)
            l->contacts[c->contact[j].kind][c->contact[j].cell] = 1;
        for (size_t j = 0; j < c->span_count; j++)
            l->slides |= c->span[j].state == GRAZE_STATE_B && c->span[j].count > 1;
    }
    return made ? GRAZE_OK : context_fail(context, GRAZE_ESYSTEM, "out of memory for a picture");
}

/* Places of the parts: panels in rows from the left, the legend on the right of them all. */
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
    graze_status status = view_classes(c, p);
    if (!status && p->has_positions)
        status = view_positions(c, context, p);
    if (!status && p->has_trajectories)
        status = view_trajectories(c, context, p);
    return status;
}

static graze_status draw_all(picture *p, graze_context *context, const char *file) {
    const lettering heading = {.size = 16, .bold = 1}, plain = {.size = 11};
    const char *title = p->request->title ? p->request->title : "";
    size_t outside = views_outside(p);
    char missing[64] = "", remark[480];
    text plane;
    text_init(&plane);
    if (p->cells.section) {
        text_put(&plane, " · ");
        section_describe(&plane, p->cells.section);
    }
    if (outside)
        snprintf(missing, sizeof missing, " · %zu of %zu points outside the picture", outside,
                 p->request->point_count);
    snprintf(
        remark, sizeof remark, "%zu × %zu cells, each %s of its centre%s%s · graze " GRAZE_VERSION,
        p->cells.count[0], p->cells.count[1],
        p->request->by_distance ? "on the exact side and by the distance" : "in the exact class",
        plane.failed || !p->cells.section ? "" : plane.data, missing);
    text_clear(&plane);
    layout l = lay_out(p, title, remark);
    canvas *c;
    graze_status status = canvas_create(&c, context, file, l.width, l.height);
    if (status)
        return status;
    canvas_text(c, MARGIN, 26, &heading, title);
    canvas_text(c, MARGIN, 44, &plain, remark);
    status = draw_panels(c, context, p);
    canvas_begin(c, "legend", NULL);
    legend_draw(c, &p->legend, l.legend_x, HEAD + PANEL_ABOVE);
    canvas_end(c);
    graze_status written = canvas_finish(c, context, file, !status);
    return status ? status : written;
}

graze_status draw_picture(graze_context *context, const graze_scene *scene, const char *file,
                          const draw_request *request) {
    picture p = {.scene = scene, .request = request};
    graze_status status = canvas_check(context, file);
    if (!status)
        status = make_cells(&p, context);
    if (!status)
        status = make_positions(&p, context);
    if (!status)
        status = make_trails(&p, context);
    if (!status)
        status = make_legend(&p, context);
    if (!status)
        status = views_fit(&p, context);
    if (!status)
        status = draw_all(&p, context, file);
    for (size_t k = 0; k < request->times && p.moved; k++)
        shape_clear(&p.moved[k]);
    shape_clear(&p.standing);
    for (size_t k = 0; k < request->point_count && p.trails; k++)
        trail_clear(&p.trails[k]);
    free(p.moved);
    free(p.trails);
    free(p.points);
    section_clear(&p.section);
    cells_clear(&p.cells);
    return status;
}
