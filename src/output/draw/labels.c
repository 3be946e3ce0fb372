/* Places for names: rings of candidates around the point, the nearest free one wins.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/views.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"

/* The bin of a pixel along an axis; the first or last bin for a pixel outside the panel. */
static int bin_of(const labels *l, int axis, double pixel) {
    double low = axis ? l->panel->y : l->panel->x;
    double size = axis ? l->panel->height : l->panel->width;
    return (int)fmin(fmax((pixel - low) / size * LABEL_BINS, 0), LABEL_BINS - 1);
}

/* The bins that a rectangle meets, by axis. */
typedef struct bin_range {
    int low[2], high[2];
} bin_range;

static bin_range bins_of(const labels *l, const obstacle *o) {
    return (bin_range){{bin_of(l, 0, o->x), bin_of(l, 1, o->y)},
                       {bin_of(l, 0, o->x + o->width), bin_of(l, 1, o->y + o->height)}};
}

static int is_outside(const panel *p, const obstacle *o) {
    return o->x > p->x + p->width || o->y > p->y + p->height || o->x + o->width < p->x ||
           o->y + o->height < p->y;
}

static void add_link(labels *l, size_t *first) {
    l->failed |= !array_reserve(&l->link, &l->link_capacity, l->link_count + 1, sizeof *l->link);
    if (l->failed)
        return;
    l->link[l->link_count++] = (obstacle_link){l->count, *first};
    *first = l->link_count;
}

static void add_label(labels *l, obstacle o) {
    if (l->failed || is_outside(l->panel, &o))
        return;
    l->failed = !array_reserve(&l->item, &l->capacity, l->count + 1, sizeof *l->item);
    if (l->failed)
        return;
    l->item[l->count++] = o;
    bin_range bins = bins_of(l, &o);
    for (int row = bins.low[1]; row <= bins.high[1]; row++)
        for (int column = bins.low[0]; column <= bins.high[0]; column++)
            add_link(l, &l->first[row][column]);
}

void labels_init(labels *l, const panel *p, int has_scale_bar) {
    memset(l, 0, sizeof *l);
    l->panel = p;
    if (has_scale_bar) { /* the axes' arrows, and the scale bar of at most 5/16 of the width */
        add_label(l, (obstacle){p->x, p->y + p->height - 72, 72, 72, OBSTACLE_MARK});
        add_label(l, (obstacle){p->x + p->width * 2 / 3, p->y + p->height - 32, p->width, 32,
                                OBSTACLE_MARK});
    }
}

void labels_clear(labels *l) {
    free(l->item);
    free(l->link);
}

static obstacle square_about(double x, double y, double radius, int kind) {
    return (obstacle){x - radius, y - radius, 2 * radius, 2 * radius, kind};
}

void labels_avoid(labels *l, double x, double y, double radius) {
    add_label(l, square_about(x, y, radius, OBSTACLE_MARK));
}

/* Add small squares along the line as obstacles, so that a slanting line does not block its whole
 * bounding box. */
void labels_avoid_path(labels *l, const drawn_path *p) {
    const double apart = 6, far = 1e5;
    for (size_t k = 1; k < p->count; k++) {
        const path_node *a = &p->node[k - 1], *b = &p->node[k];
        double from[2] = {a->x, a->y}, to[2] = {b->x, b->y}, share[2];
        if (b->verb != 'L' || fabs(a->x) + fabs(a->y) + fabs(b->x) + fabs(b->y) > far ||
            !panel_clip_segment(share, l->panel, from, to))
            continue;
        double dx = b->x - a->x, dy = b->y - a->y;
        int parts = (int)ceil(sqrt(dx * dx + dy * dy) / apart);
        int first = (int)fmax(share[0] * parts, 1), last = (int)fmin(share[1] * parts + 1, parts);
        for (int j = first; j <= last; j++)
            add_label(l,
                      square_about(a->x + dx * j / parts, a->y + dy * j / parts, 2, OBSTACLE_LINE));
    }
}

/* A name remains legible if its box shares at most this number of square pixels with obstacles. */
static const double FREE = 12;

/* The area that a box has in common with the obstacles; the sum stops once it exceeds FREE. Each
 * common area is counted in one bin alone, that of its upper left corner. */
static double common_area(const labels *l, const obstacle *o, int marks_only) {
    double sum = 0;
    bin_range bins = bins_of(l, o);
    for (int row = bins.low[1]; row <= bins.high[1]; row++)
        for (int column = bins.low[0]; column <= bins.high[0]; column++)
            for (size_t k = l->first[row][column]; k && sum <= FREE; k = l->link[k - 1].next) {
                const obstacle *other = &l->item[l->link[k - 1].item - 1];
                double x = fmax(o->x, other->x), y = fmax(o->y, other->y);
                double w = fmin(o->x + o->width, other->x + other->width) - x;
                double h = fmin(o->y + o->height, other->y + other->height) - y;
                if (w > 0 && h > 0 && bin_of(l, 0, x) == column && bin_of(l, 1, y) == row &&
                    !(marks_only && other->kind != OBSTACLE_MARK))
                    sum += w * h;
            }
    return sum;
}

int labels_meet_mark(const labels *l, double x, double y, double radius) {
    obstacle o = square_about(x, y, radius, OBSTACLE_MARK);
    return common_area(l, &o, 1) > 0;
}

/* The area that a box has in common with obstacles; infinite if the box leaves the panel. */
static double cost(const labels *l, const obstacle *o) {
    const panel *p = l->panel;
    return o->x < p->x || o->y < p->y || o->x + o->width > p->x + p->width ||
                   o->y + o->height > p->y + p->height
               ? INFINITY
               : common_area(l, o, 0);
}

/* The line from a pixel to the nearest point of a name's box. */
typedef struct leader {
    double x, y, dx, dy;
} leader;

static leader leader_to(double x, double y, const obstacle *o) {
    return (leader){x, y, fmin(fmax(x, o->x), o->x + o->width) - x,
                    fmin(fmax(y, o->y), o->y + o->height) - y};
}

/* Does the line to a name's box run over another name? */
static int crosses_name(const labels *l, const leader *line) {
    enum { PARTS = 24 };
    for (int j = 0; j <= PARTS; j++) {
        double x = line->x + line->dx * j / PARTS, y = line->y + line->dy * j / PARTS;
        size_t k = l->first[bin_of(l, 1, y)][bin_of(l, 0, x)];
        for (; k; k = l->link[k - 1].next) {
            const obstacle *n = &l->item[l->link[k - 1].item - 1];
            if (n->kind == OBSTACLE_NAME && x > n->x && x < n->x + n->width && y > n->y &&
                y < n->y + n->height)
                return 1;
        }
    }
    return 0;
}

/* Draw the line to a name's box. It begins outside the sign, and is left out if it would be short.
 */
static void draw_leader(labels *l, canvas *c, const leader *line, double sign) {
    const style thin = {.stroke = PAINT(0x555555), .width = .7};
    const double beside = sign > 0 ? sign + 1 : 0, least = 6;
    double length = sqrt(line->dx * line->dx + line->dy * line->dy);
    if (length < beside + least)
        return;
    drawn_path drawn = {NULL, 0, 0, 0};
    drawn_path_line(&drawn, line->x + line->dx * beside / length,
                    line->y + line->dy * beside / length, line->x + line->dx, line->y + line->dy);
    labels_avoid_path(l, &drawn);
    canvas_path(c, &drawn, &thin, NULL);
}

/* The box of a name in one of eight directions from a pixel, with its nearest point at the distance
 * `away` in this direction. */
static obstacle box_beside(double x, double y, double away, const double direction[2], double width,
                           double height) {
    double share_x = direction[0] > .1 ? 0 : direction[0] < -.1 ? 1 : .5;
    double share_y = direction[1] > .1 ? 0 : direction[1] < -.1 ? 1 : .5;
    return (obstacle){x + away * direction[0] - share_x * width,
                      y + away * direction[1] - share_y * height, width, height, OBSTACLE_NAME};
}

int labels_place(labels *l, canvas *c, labelled_point at, const char *name) {
    static const double rings[] = {7, 14, 24, 36, 52, 72, 96, 124};
    static const double around[][2] = {{.7, -.7}, {.7, .7}, {-.7, -.7}, {-.7, .7},
                                       {0, -1},   {1, 0},   {0, 1},     {-1, 0}};
    const lettering letters = {.size = 13, .halo = 1};
    double width = canvas_text_width(name, letters.size), height = 14, least = INFINITY;
    obstacle best = {at.x, at.y, width, height, OBSTACLE_NAME};
    for (int r = 0; r < 8 && least > 0 && rings[r] <= at.reach; r++)
        for (int k = 0; k < 8 && least > 0; k++) {
            obstacle o = box_beside(at.x, at.y, rings[r], around[k], width, height);
            leader line = leader_to(at.x, at.y, &o);
            double price = cost(l, &o);
            if (price <= FREE && price < least && !crosses_name(l, &line)) {
                least = price;
                best = o;
            }
        }
    if (least > FREE)
        return 0;
    leader line = leader_to(at.x, at.y, &best);
    draw_leader(l, c, &line, at.sign);
    canvas_text(c, best.x, best.y + 11.3, &letters, name);
    add_label(l, best);
    c->failed |= l->failed;
    return 1;
}

void labels_tell(const labels *l, canvas *c) {
    const panel *p = l->panel;
    const lettering small = {.size = 10, .anchor = ANCHOR_END};
    char message[64];
    if (!l->left_out)
        return;
    snprintf(message, sizeof message, "no room for %u name%s", l->left_out,
             l->left_out == 1 ? "" : "s");
    canvas_text(c, p->x + p->width, p->y - 9, &small, message);
}
