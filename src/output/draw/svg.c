/* A canvas that is an SVG text.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Coordinates have two decimals and are written with integers alone, so that the same picture is
 * the same bytes in any locale.
 */
#include "output/draw/views.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

typedef struct svg_canvas {
    canvas base;
    text out;
    unsigned clips;
} svg_canvas;

static text *out_of(canvas *c) {
    return &((svg_canvas *)c)->out;
}

/* A coordinate in hundredths of a pixel. Coordinates far outside the picture are replaced by 1e6 or
 * -1e6 pixels. */
static long hundredths(double value) {
    const double far = 1e6;
    if (!(value > -far))
        value = -far;
    return lround((value < far ? value : far) * 100);
}

static void put_hundredths(text *t, long value) {
    unsigned long size = (unsigned long)labs(value);
    text_put(t, value < 0 ? "-" : "");
    text_count(t, size / 100);
    if (size % 100)
        text_format(t, size % 10 ? ".%02lu" : ".%lu", size % 10 ? size % 100 : size % 100 / 10);
}

/* Append a text in which each @ is replaced by the next number of pixels. */
static void put_pixels(text *t, const char *form, ...) {
    va_list values;
    va_start(values, form);
    for (; *form; form++)
        if (*form == '@')
            put_hundredths(t, hundredths(va_arg(values, double)));
        else
            text_bytes(t, form, 1);
    va_end(values);
}

static void put_escaped(text *t, const char *string) {
    static const char marks[] = "<&\">";
    static const char *const names[] = {"&lt;", "&amp;", "&quot;", "&gt;"};
    for (; *string; string++) {
        const char *mark = strchr(marks, *string);
        text_bytes(t, mark ? names[mark - marks] : string, mark ? strlen(names[mark - marks]) : 1);
    }
}

static void put_style(text *t, const style *s) {
    if (s->fill)
        text_format(t, " fill=\"#%06x\"", s->fill & 0xffffff);
    else
        text_put(t, " fill=\"none\"");
    if (s->stroke) {
        text_format(t, " stroke=\"#%06x\"", s->stroke & 0xffffff);
        put_pixels(t, " stroke-width=\"@\" stroke-linejoin=\"round\"", s->width);
    }
    if (s->stroke && s->dash > 0)
        put_pixels(t, " stroke-dasharray=\"@\"", s->dash);
    if (s->faintness > 0)
        put_pixels(t, " opacity=\"@\"", 1 - s->faintness);
    if (s->crisp)
        text_put(t, " shape-rendering=\"crispEdges\"");
}

static void svg_begin(canvas *c, const char *name, const char *attributes) {
    text *t = out_of(c);
    text_format(t, "<g class=\"%s\"%s%s>\n", name, attributes ? " " : "",
                attributes ? attributes : "");
}

static void svg_end(canvas *c) {
    text_put(out_of(c), "</g>\n");
}

static void svg_clip(canvas *c, double x, double y, double width, double height) {
    text *t = out_of(c);
    unsigned number = ++((svg_canvas *)c)->clips;
    text_format(t, "<clipPath id=\"clip%u\">", number);
    put_pixels(t, "<rect x=\"@\" y=\"@\" width=\"@\" height=\"@\"/>", x, y, width, height);
    text_format(t, "</clipPath>\n<g clip-path=\"url(#clip%u)\">\n", number);
}

/* Append the nodes of a path. Lines along an axis are written as H and V, since the cells of a grid
 * are most of a picture's bytes. */
static void put_nodes(text *t, const drawn_path *p) {
    long x = 0, y = 0;
    for (size_t k = 0; k < p->count; k++) {
        const path_node *n = &p->node[k];
        if (n->verb == 'z') {
            text_put(t, "z");
            continue;
        }
        long to_x = hundredths(n->x), to_y = hundredths(n->y);
        if (n->verb == 'L' && to_y == y)
            put_pixels(t, "H@", n->x);
        else if (n->verb == 'L' && to_x == x)
            put_pixels(t, "V@", n->y);
        else
            put_pixels(t, n->verb == 'M' ? "M@ @" : "L@ @", n->x, n->y);
        x = to_x;
        y = to_y;
    }
}

static void svg_path(canvas *c, const drawn_path *p, const style *s, const char *name) {
    text *t = out_of(c);
    text_put(t, "<path");
    if (name)
        text_format(t, " class=\"%s\"", name);
    put_style(t, s);
    if (s->fill)
        text_put(t, " fill-rule=\"evenodd\"");
    text_put(t, " d=\"");
    put_nodes(t, p);
    text_put(t, "\"/>\n");
}

static void svg_circle(canvas *c, double x, double y, double radius, const style *s) {
    text *t = out_of(c);
    put_pixels(t, "<circle cx=\"@\" cy=\"@\" r=\"@\"", x, y, radius);
    put_style(t, s);
    text_put(t, "/>\n");
}

static void svg_text(canvas *c, double x, double y, const lettering *l, const char *string) {
    static const char *const anchors[] = {"start", "middle", "end"};
    text *t = out_of(c);
    put_pixels(t, "<text x=\"@\" y=\"@\" font-size=\"@\"", x, y, l->size);
    text_format(t, " text-anchor=\"%s\"", anchors[l->anchor]);
    text_put(t, l->bold ? " font-weight=\"bold\"" : "");
    if (l->halo)
        text_put(t, " stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\" "
                    "paint-order=\"stroke\"");
    text_put(t, ">");
    put_escaped(t, string);
    text_put(t, "</text>\n");
}

static void svg_finish(canvas *c, canvas_put *put, void *to) {
    text *t = out_of(c);
    text_put(t, "</svg>\n");
    c->failed |= t->failed || !put(to, t->data, t->length);
}

static void svg_destroy(canvas *c) {
    text_clear(out_of(c));
    free(c);
}

static const canvas_kind svg_kind = {svg_begin,  svg_end,  svg_clip,   svg_end,    svg_path,
                                     svg_circle, svg_text, svg_finish, svg_destroy};

graze_status canvas_create_svg(canvas **out, graze_context *context, double width, double height) {
    svg_canvas *c = calloc(1, sizeof *c);
    if (!c)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a picture");
    c->base = (canvas){&svg_kind, width, height, 0};
    text *t = &c->out;
    put_pixels(t,
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"@\" height=\"@\" "
               "viewBox=\"0 0 @ @\"",
               width, height, width, height);
    text_format(t, " font-family=\"DejaVu Sans, Verdana, sans-serif\" fill=\"#%06x\">\n", INK);
    put_pixels(t, "<rect width=\"@\" height=\"@\" fill=\"#ffffff\"/>\n", width, height);
    *out = &c->base;
    return GRAZE_OK;
}
