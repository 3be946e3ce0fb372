/* A canvas that is a PNG image, with two pixels along each axis for one of the canvas, or a page of
 * PDF.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * It is a shared object of its own, which output/draw/canvas.c loads when it is needed, since cairo
 * brings along libraries of a window system, which nothing else of Graze needs.
 */
#include <cairo/cairo-pdf.h>
#include <stdlib.h>
#include "output/draw/draw.h"

typedef struct png_canvas {
    canvas base;
    cairo_surface_t *surface;
    cairo_t *to;
    int pdf; /* 1: the surface records the drawing for write_page */
} png_canvas;

/* Pixels of an image, and points of a page, for each pixel of the picture. */
static const int scale = 2;
static const double page_scale = .75;

static void set_paint(png_canvas *p, unsigned paint, double faintness) {
    cairo_set_source_rgba(p->to, (paint >> 16 & 255) / 255.0, (paint >> 8 & 255) / 255.0,
                          (paint & 255) / 255.0, 1 - faintness);
}

static void png_clip(canvas *c, double x, double y, double width, double height) {
    png_canvas *p = (png_canvas *)c;
    cairo_save(p->to);
    cairo_new_path(p->to);
    cairo_rectangle(p->to, x, y, width, height);
    cairo_clip(p->to);
}

static void png_unclip(canvas *c) {
    png_canvas *p = (png_canvas *)c;
    cairo_restore(p->to);
}

/* Fill and stroke cairo's current path. */
static void png_draw(png_canvas *p, const style *s) {
    cairo_set_antialias(p->to, s->crisp ? CAIRO_ANTIALIAS_NONE : CAIRO_ANTIALIAS_DEFAULT);
    if (s->fill) {
        set_paint(p, s->fill, s->faintness);
        cairo_fill_preserve(p->to);
    }
    if (s->stroke) {
        set_paint(p, s->stroke, s->faintness);
        cairo_set_line_width(p->to, s->width);
        cairo_set_dash(p->to, &s->dash, s->dash > 0, 0);
        cairo_stroke(p->to);
    }
    cairo_new_path(p->to);
}

/* A coordinate for cairo, whose numbers are fixed-point: at most 1e5 in size. */
static double bounded(double value) {
    const double far = 1e5;
    return value > -far ? value < far ? value : far : -far;
}

static void png_path(canvas *c, const drawn_path *shape, const style *s, const char *name) {
    png_canvas *p = (png_canvas *)c;
    (void)name;
    cairo_new_path(p->to);
    for (size_t k = 0; k < shape->count; k++) {
        const path_node *n = &shape->node[k];
        if (n->verb == 'z')
            cairo_close_path(p->to);
        else
            (n->verb == 'M' ? cairo_move_to : cairo_line_to)(p->to, bounded(n->x), bounded(n->y));
    }
    png_draw(p, s);
}

static void png_circle(canvas *c, double x, double y, double radius, const style *s) {
    png_canvas *p = (png_canvas *)c;
    cairo_new_path(p->to);
    cairo_arc(p->to, bounded(x), bounded(y), radius, 0, 6.283185307179586);
    cairo_close_path(p->to);
    png_draw(p, s);
}

static void png_text(canvas *c, double x, double y, const lettering *l, const char *string) {
    png_canvas *p = (png_canvas *)c;
    cairo_text_extents_t size;
    cairo_select_font_face(p->to, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           l->bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(p->to, l->size);
    cairo_set_fill_rule(p->to, CAIRO_FILL_RULE_WINDING);
    cairo_text_extents(p->to, string, &size);
    x -= l->anchor == ANCHOR_START ? 0 : size.x_advance / (l->anchor == ANCHOR_MIDDLE ? 2 : 1);
    cairo_new_path(p->to);
    cairo_move_to(p->to, x, y);
    cairo_text_path(p->to, string);
    if (l->halo) {
        png_draw(p, &(style){.stroke = PAINT(0xffffff), .width = 3});
        cairo_move_to(p->to, x, y);
        cairo_text_path(p->to, string);
    }
    png_draw(p, &(style){.fill = PAINT(INK)});
    cairo_set_fill_rule(p->to, CAIRO_FILL_RULE_EVEN_ODD);
}

/* Destination of the bytes of the file. */
typedef struct sink {
    canvas_put *put;
    void *to;
} sink;

static cairo_status_t png_keep(void *closure, const unsigned char *data, unsigned length) {
    const sink *s = closure;
    return s->put(s->to, (const char *)data, length) ? CAIRO_STATUS_SUCCESS
                                                     : CAIRO_STATUS_NO_MEMORY;
}

/* Write the PDF page, without a date, so that equal pictures are equal files. */
static cairo_status_t write_page(const png_canvas *p, sink *s) {
    cairo_surface_t *page = cairo_pdf_surface_create_for_stream(
        png_keep, s, p->base.width * page_scale, p->base.height * page_scale);
    cairo_pdf_surface_set_metadata(page, CAIRO_PDF_METADATA_CREATE_DATE, "");
    cairo_t *to = cairo_create(page);
    cairo_scale(to, page_scale, page_scale);
    cairo_set_source_surface(to, p->surface, 0, 0);
    cairo_paint(to);
    cairo_status_t status = cairo_status(to);
    cairo_destroy(to);
    cairo_surface_finish(page);
    status = status ? status : cairo_surface_status(page);
    cairo_surface_destroy(page);
    return status;
}

static void png_finish(canvas *c, canvas_put *put, void *to) {
    png_canvas *p = (png_canvas *)c;
    sink s = {put, to};
    c->failed |= cairo_status(p->to) != CAIRO_STATUS_SUCCESS;
    if (!c->failed)
        c->failed = (p->pdf ? write_page(p, &s)
                            : cairo_surface_write_to_png_stream(p->surface, png_keep, &s)) !=
                    CAIRO_STATUS_SUCCESS;
}

static void png_destroy(canvas *c) {
    png_canvas *p = (png_canvas *)c;
    cairo_destroy(p->to);
    cairo_surface_destroy(p->surface);
    free(p);
}

static const canvas_kind png_kind = {NULL,       NULL,     png_clip,   png_unclip, png_path,
                                     png_circle, png_text, png_finish, png_destroy};

__attribute__((visibility("default"))) canvas *graze_png_create(double width, double height,
                                                                int pdf) {
    png_canvas *p = calloc(1, sizeof *p);
    if (!p)
        return NULL;
    p->base = (canvas){&png_kind, width, height, 0};
    p->pdf = pdf;
    /* Without bounds cairo leaks the recording. They exceed the page, whose edge would show them.
     */
    cairo_rectangle_t all = {-1, -1, width + 2, height + 2};
    p->surface = pdf ? cairo_recording_surface_create(CAIRO_CONTENT_COLOR, &all)
                     : cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)(width * scale),
                                                  (int)(height * scale));
    p->to = cairo_create(p->surface);
    if (!pdf)
        cairo_scale(p->to, scale, scale);
    cairo_set_fill_rule(p->to, CAIRO_FILL_RULE_EVEN_ODD);
    cairo_set_line_join(p->to, CAIRO_LINE_JOIN_ROUND);
    set_paint(p, PAINT(0xffffff), 0);
    cairo_paint(p->to);
    return &p->base;
}
