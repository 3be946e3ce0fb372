/* Places for names: rings of candidates around the point, the nearest free one wins.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "draw/labels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

void labels_clear(labels *l) {
    free(l->item);
    *l = (labels){NULL, 0, 0, 0, 0};
}

static void add(labels *l, obstacle o) {
    if (l->count == l->capacity && !l->failed) {
        size_t capacity = 2 * l->capacity + 64;
        obstacle *grown = realloc(l->item, capacity * sizeof *grown);
        l->failed = !grown;
        if (grown) {
            l->item = grown;
            l->capacity = capacity;
        }
    }
    if (!l->failed)
        l->item[l->count++] = o;
}

void labels_avoid(labels *l, double x, double y, double radius) {
    add(l, (obstacle){x - radius, y - radius, 2 * radius, 2 * radius});
}

/* Small squares along the line, so that a slanting one does not keep its whole box free. */
void labels_avoid_path(labels *l, const path *p) {
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

/* From the pixel to the middle of a name's nearer side. */
static void draw_leader(canvas *c, double x, double y, const obstacle *o) {
    const style thin = {.stroke = PAINT(0x555555), .width = .7};
    path line = {NULL, 0, 0, 0};
    path_to(&line, 'M', x, y);
    path_to(&line, 'L', fmin(fmax(x, o->x), o->x + o->width),
            fmin(fmax(y, o->y), o->y + o->height));
    canvas_path(c, &line, &thin, NULL);
    path_clear(&line);
}

int labels_place(labels *l, canvas *c, const panel *p, double x, double y, const char *name) {
    static const double rings[] = {7, 14, 24, 36, 52, 72, 96, 124};
    static const double around[][2] = {{.7, -.7}, {.7, .7}, {-.7, -.7}, {-.7, .7},
                                       {0, -1},   {1, 0},   {0, 1},     {-1, 0}};
    const lettering letters = {.size = 12, .halo = 1};
    double width = canvas_text_width(name, letters.size), height = 13, least = INFINITY;
    obstacle best = {x, y, width, height};
    int ring = 0;
    for (int r = 0; r < 8 && least > 0; r++)
        for (int k = 0; k < 8 && least > 0; k++) {
            double dx = around[k][0], dy = around[k][1];
            obstacle o = {x + rings[r] * dx -
                              (dx > .1    ? 0
                               : dx < -.1 ? width
                                          : width / 2),
                          y + rings[r] * dy -
                              (dy > .1    ? 0
                               : dy < -.1 ? height
                                          : height / 2),
                          width, height};
            double price = cost(l, p, &o);
            if (price < least) {
                least = price;
                best = o;
                ring = r;
            }
        }
    if (least > FREE)
        return 0;
    if (ring > 0)
        draw_leader(c, x, y, &best);
    canvas_text(c, best.x, best.y + 10.5, &letters, name);
    add(l, best);
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
