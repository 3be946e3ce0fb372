/* A canvas that is a PNG image, two of its pixels to one of the canvas.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdlib.h>
#include "draw/cairo.h"
#include "draw/canvas.h"

typedef struct png_canvas {
    canvas base;
    cairo_functions use;
    cairo_surface_t *surface;
    cairo_t *to;
} png_canvas;

static const int scale = 2;

static void set_paint(png_canvas *p, unsigned paint, double faintness) {
    p->use.set_source_rgba(p->to, (paint >> 16 & 255) / 255.0, (paint >> 8 & 255) / 255.0,
                           (paint & 255) / 255.0, 1 - faintness);
}

static void begin(canvas *c, const char *name, const char *attributes) {
    (void)c, (void)name, (void)attributes;
}

static void end(canvas *c) {
    (void)c;
}

static void clip(canvas *c, double x, double y, double width, double height) {
    png_canvas *p = (png_canvas *)c;
    p->use.save(p->to);
    p->use.new_path(p->to);
    p->use.rectangle(p->to, x, y, width, height);
    p->use.clip(p->to);
}

static void unclip(canvas *c) {
    png_canvas *p = (png_canvas *)c;
    p->use.restore(p->to);
}

/* Fill and stroke what has been laid out. */
static void draw(png_canvas *p, const style *s) {
    p->use.set_antialias(p->to, s->crisp ? CAIRO_ANTIALIAS_OFF : CAIRO_ANTIALIAS_ON);
    if (s->fill) {
        set_paint(p, s->fill, s->faintness);
        p->use.fill_preserve(p->to);
    }
    if (s->stroke) {
        set_paint(p, s->stroke, s->faintness);
        p->use.set_line_width(p->to, s->width);
        p->use.set_dash(p->to, &s->dash, s->dash > 0, 0);
        p->use.stroke(p->to);
    }
    p->use.new_path(p->to);
}

/* Cairo's coordinates are fixed-point numbers; far outside the picture all are alike. */
static double bounded(double value) {
    const double far = 1e5;
    return value > -far ? value < far ? value : far : -far;
}

static void draw_path(canvas *c, const path *shape, const style *s, const char *name) {
    png_canvas *p = (png_canvas *)c;
    (void)name;
    p->use.new_path(p->to);
    for (size_t k = 0; k < shape->count; k++) {
        const path_node *n = &shape->node[k];
        if (n->verb == 'z')
            p->use.close_path(p->to);
        else
            (n->verb == 'M' ? p->use.move_to : p->use.line_to)(p->to, bounded(n->x), bounded(n->y));
    }
    draw(p, s);
}

static void draw_circle(canvas *c, double x, double y, double radius, const style *s) {
    png_canvas *p = (png_canvas *)c;
    p->use.new_path(p->to);
    p->use.arc(p->to, bounded(x), bounded(y), radius, 0, 6.283185307179586);
    p->use.close_path(p->to);
    draw(p, s);
}

static void draw_text(canvas *c, double x, double y, const lettering *l, const char *string) {
    png_canvas *p = (png_canvas *)c;
    cairo_extents size;
    p->use.select_font_face(p->to, "sans-serif", CAIRO_SLANT_NONE, l->bold ? 1 : 0);
    p->use.set_font_size(p->to, l->size);
    p->use.set_fill_rule(p->to, CAIRO_WINDING);
    p->use.text_extents(p->to, string, &size);
    x -= l->anchor == ANCHOR_START ? 0 : size.x_advance / (l->anchor == ANCHOR_MIDDLE ? 2 : 1);
    p->use.new_path(p->to);
    p->use.move_to(p->to, x, y);
    p->use.text_path(p->to, string);
    if (l->halo) {
        const style rim = {.stroke = PAINT(0xffffff), .width = 3};
        draw(p, &rim);
        p->use.move_to(p->to, x, y);
        p->use.text_path(p->to, string);
    }
    const style letters = {.fill = PAINT(INK)};
    draw(p, &letters);
    p->use.set_fill_rule(p->to, CAIRO_EVEN_ODD);
}

static unsigned keep(void *closure, const unsigned char *data, unsigned length) {
    text *t = closure;
    text_bytes(t, (const char *)data, length);
    return t->failed ? 1 : 0; /* CAIRO_STATUS_NO_MEMORY */
}

static void finish(canvas *c, text *out) {
    png_canvas *p = (png_canvas *)c;
    c->failed |= p->use.status(p->to) != 0;
    if (!c->failed)
        c->failed = p->use.surface_write_to_png_stream(p->surface, keep, out) != 0;
}

static void destroy(canvas *c) {
    png_canvas *p = (png_canvas *)c;
    p->use.destroy(p->to);
    p->use.surface_destroy(p->surface);
    free(p);
}

static const canvas_kind png_kind = {begin,       end,       clip,   unclip, draw_path,
                                     draw_circle, draw_text, finish, destroy};

graze_status canvas_create_png(canvas **out, graze_context *context, double width, double height) {
    png_canvas *p = calloc(1, sizeof *p);
    if (!p)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a picture");
    graze_status status = cairo_find(&p->use, context);
    if (status) {
        free(p);
        return status;
    }
    p->base = (canvas){&png_kind, width, height, 0};
    p->surface =
        p->use.image_surface_create(CAIRO_RGB24, (int)(width * scale), (int)(height * scale));
    p->to = p->use.create(p->surface);
    p->use.scale(p->to, scale, scale);
    p->use.set_fill_rule(p->to, CAIRO_EVEN_ODD);
    p->use.set_line_join(p->to, CAIRO_JOIN_ROUND);
    set_paint(p, PAINT(0xffffff), 0);
    p->use.paint(p->to);
    *out = &p->base;
    return GRAZE_OK;
}
