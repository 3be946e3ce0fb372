/* Places for names: rings of candidates around the point, the nearest free one wins.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/labels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "base/context/array.h"

void labels_clear(labels *l) {
    free(l->item);
    *l = (labels){NULL, 0, 0, 0, 0};
}

static void add_label(labels *l, obstacle o) {
    if (!l->failed)
        l->failed = !array_reserve(&l->item, &l->capacity, l->count + 1, sizeof *l->item);
    if (!l->failed)
        l->item[l->count++] = o;
}

void labels_avoid(labels *l, double x, double y, double radius) {
    add_label(l, (obstacle){x - radius, y - radius, 2 * radius, 2 * radius, 0});
}

/* Small squares along the line, so that a slanting one does not keep its whole box free. */
void labels_avoid_path(labels *l, const drawn_path *p) {
    const double apart = 6, far = 1e5;
    for (size_t k = 1; k < p->count; k++) {
        const path_node *a = &p->node[k - 1], *b = &p->node[k];
        if (b->verb != 'L' || fabs(a->x) + fabs(a->y) + fabs(b->x) + fabs(b->y) > far)
            continue;
        double dx = b->x - a->x, dy = b->y - a->y;
        int parts = (int)ceil(sqrt(dx * dx + dy * dy) / apart);
        for (int j = 1; j <= parts; j++)
            labels_avoid(l, a->x + dx * j / parts, a->y + dy * j / parts, 2);
    }
}

/* The area that a rectangle has in common with the obstacles, and far more for what leaves the
 * panel. */
static double cost(const labels *l, const panel *p, const obstacle *o) {
    double sum = 0;
    for (size_t k = 0; k < l->count; k++) {
        const obstacle *other = &l->item[k];
        double w = fmin(o->x + o->width, other->x + other->width) - fmax(o->x, other->x);
        double h = fmin(o->y + o->height, other->y + other->height) - fmax(o->y, other->y);
        if (w > 0 && h > 0)
            sum += w * h;
    }
    int inside = o->x >= p->x && o->y >= p->y && o->x + o->width <= p->x + p->width &&
                 o->y + o->height <= p->y + p->height;
    return inside ? sum : sum + 1e6;
}

/* So many square pixels in common with others do not make a name illegible. */
static const double FREE = 12;

/* The line from a pixel to the nearest point of a name's box. */
typedef struct leader {
    double x, y, dx, dy;
} leader;

static leader leader_to(double x, double y, const obstacle *o) {
    return (leader){x, y, fmin(fmax(x, o->x), o->x + o->width) - x,
                    fmin(fmax(y, o->y), o->y + o->height) - y};
}

/* Whether the line to a name's box runs over another name. */
static int crosses_name(const labels *l, const leader *line) {
    enum { PARTS = 24 };
    for (size_t k = 0; k < l->count; k++) {
        const obstacle *n = &l->item[k];
        for (int j = 0; n->name && j <= PARTS; j++) {
            double x = line->x + line->dx * j / PARTS, y = line->y + line->dy * j / PARTS;
            if (x > n->x && x < n->x + n->width && y > n->y && y < n->y + n->height)
                return 1;
        }
    }
    return 0;
}

/* It begins outside the sign; where little of it is left, it is needless. */
static void draw_leader(labels *l, canvas *c, const leader *line, double sign) {
    const style thin = {.stroke = PAINT(0x555555), .width = .7};
    const double beside = sign > 0 ? sign + 1 : 0, least = 6;
    double length = sqrt(line->dx * line->dx + line->dy * line->dy);
    if (length < beside + least)
        return;
    drawn_path drawn = {NULL, 0, 0, 0};
    drawn_path_to(&drawn, 'M', line->x + line->dx * beside / length,
                  line->y + line->dy * beside / length);
    drawn_path_to(&drawn, 'L', line->x + line->dx, line->y + line->dy);
    canvas_path(c, &drawn, &thin, NULL);
    labels_avoid_path(l, &drawn);
    drawn_path_clear(&drawn);
}

/* A box in one of eight directions from a pixel, its nearest point so far away along both axes. */
static obstacle box_beside(double x, double y, double away, const double direction[2], double width,
                           double height) {
    double share_x = direction[0] > .1 ? 0 : direction[0] < -.1 ? 1 : .5;
    double share_y = direction[1] > .1 ? 0 : direction[1] < -.1 ? 1 : .5;
    return (obstacle){x + away * direction[0] - share_x * width,
                      y + away * direction[1] - share_y * height, width, height, 1};
}

int labels_place(labels *l, canvas *c, const panel *p, labelled_point at, const char *name) {
    static const double rings[] = {7, 14, 24, 36, 52, 72, 96, 124};
    static const double around[][2] = {{.7, -.7}, {.7, .7}, {-.7, -.7}, {-.7, .7},
                                       {0, -1},   {1, 0},   {0, 1},     {-1, 0}};
    const lettering letters = {.size = 12, .halo = 1};
    double width = canvas_text_width(name, letters.size), height = 13, least = INFINITY;
    obstacle best = {at.x, at.y, width, height, 1};
    for (int r = 0; r < 8 && least > 0 && rings[r] <= at.reach; r++)
        for (int k = 0; k < 8 && least > 0; k++) {
            obstacle o = box_beside(at.x, at.y, rings[r], around[k], width, height);
            leader line = leader_to(at.x, at.y, &o);
            double price = cost(l, p, &o) + (crosses_name(l, &line) ? 1e3 : 0);
            if (price < least) {
                least = price;
                best = o;
            }
        }
    if (least > FREE)
        return 0;
    leader line = leader_to(at.x, at.y, &best);
    draw_leader(l, c, &line, at.sign);
    canvas_text(c, best.x, best.y + 10.5, &letters, name);
    add_label(l, best);
    c->failed |= l->failed;
    return 1;
}

void labels_tell(const labels *l, canvas *c, const panel *p) {
    const lettering small = {.size = 10, .anchor = ANCHOR_END};
    char message[64];
    if (!l->left_out)
        return;
    snprintf(message, sizeof message, "no room for %u name%s", l->left_out,
             l->left_out == 1 ? "" : "s");
    canvas_text(c, p->x + p->width, p->y - 9, &small, message);
}
