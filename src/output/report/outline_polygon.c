/* Polygons of an outline as well-known text, GeoJSON, SVG and legacy VTK; points beside its pieces.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/report.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/vector.h"

/* Words of a form: before and behind all, a polygon, a ring and a point, and between neighbours and
 * coordinates. */
typedef struct polygon_words {
    const char *head, *tail, *shell[2], *ring[2], *point[2], *between, *comma;
} polygon_words;

static const polygon_words words_of[] = {
    {"MULTIPOLYGON (", ")\n", {"(", ")"}, {"(", ")"}, {"", ""}, ", ", " "},
    {"{\"type\": \"MultiPolygon\", \"coordinates\": [",
     "]}\n",
     {"[", "]"},
     {"[", "]"},
     {"[", "]"},
     ", ",
     ", "},
    {"<path fill-rule=\"evenodd\" transform=\"scale(1 -1)\" d=\"",
     "\"/>\n</svg>\n",
     {"", ""},
     {"M", "Z"},
     {"", ""},
     " ",
     ","},
    {"", "", {"", ""}, {"", ""}, {"", " 0\n"}, "", " "}};

static double corner_coordinate(const outline_polygon *p, size_t edge, int axis) {
    return ldexp((double)p->edge[edge].at[axis], -(int)p->places);
}

static void put_polygon_corner(text *t, const outline_polygon *p, size_t k,
                               const polygon_words *w) {
    text_format(t, "%s%.17g%s%.17g%s", w->point[0], corner_coordinate(p, k, 0), w->comma,
                corner_coordinate(p, k, 1), w->point[1]);
}

/* Append the points of a ring, the first one again at its end; returns their number. */
static size_t put_polygon_ring(text *t, const outline_polygon *p, size_t ring,
                               const polygon_words *w) {
    size_t count = 0, first = p->first[ring];
    text_put(t, w->ring[0]);
    for (size_t k = first; count == 0 || k != first; k = p->edge[k].next, count++) {
        put_polygon_corner(t, p, k, w);
        text_put(t, w->between);
    }
    put_polygon_corner(t, p, first, w);
    text_put(t, w->ring[1]);
    return count + 1;
}

/* Append each polygon: a ring, and its holes. In VTK all rings' points, then their numbers. */
static void put_polygons(text *t, text *lines, const outline_polygon *p, const polygon_words *w) {
    size_t used = 0;
    for (size_t r = 0; r < p->ring_count; r++) {
        if (p->within[r] != r)
            continue;
        text_put(t, used ? w->between : "");
        text_put(t, w->shell[0]);
        for (size_t pass = 0; pass < 2; pass++)
            for (size_t h = 0; h < p->ring_count; h++) {
                if (p->within[h] != r || pass == (h == r))
                    continue;
                text_put(t, pass ? w->between : "");
                size_t end = used + put_polygon_ring(t, p, h, w);
                text_format(lines, "%zu", end - used);
                while (used < end)
                    text_format(lines, " %zu", used++);
                text_put(lines, "\n");
            }
        text_put(t, w->shell[1]);
    }
}

/* Append the frame of a picture, with a margin of a 20th. */
static void put_frame(text *t, const outline_polygon *p) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (size_t k = 0; k < p->count; k++)
        for (int i = 0; i < 2; i++) {
            low[i] = fmin(low[i], corner_coordinate(p, k, i));
            high[i] = fmax(high[i], corner_coordinate(p, k, i));
        }
    double margin = p->count ? fmax(high[0] - low[0], high[1] - low[1]) / 20 : 0;
    text_format(
        t, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"%.17g %.17g %.17g %.17g\">\n",
        p->count ? low[0] - margin : 0, p->count ? -high[1] - margin : 0,
        p->count ? high[0] - low[0] + 2 * margin : 1, p->count ? high[1] - low[1] + 2 * margin : 1);
}

void outline_polygon_text(text *t, const outline_polygon *p, graze_polygon_format format) {
    size_t rings = p->ring_count, points = p->count + rings;
    HELD(text, lines);
    if (format == GRAZE_POLYGON_WKT && rings == 0) {
        text_put(t, "MULTIPOLYGON EMPTY\n");
        return;
    }
    if (format == GRAZE_POLYGON_VTK)
        text_format(t,
                    "# vtk DataFile Version 3.0\noutline of graze\nASCII\nDATASET POLYDATA\n"
                    "POINTS %zu double\n",
                    points);
    if (format == GRAZE_POLYGON_SVG)
        put_frame(t, p);
    text_put(t, words_of[format].head);
    put_polygons(t, &lines, p, &words_of[format]);
    text_put(t, words_of[format].tail);
    if (format != GRAZE_POLYGON_VTK)
        return;
    text_format(t, "LINES %zu %zu\n", rings, points + rings);
    text_owned(t, text_take(&lines));
}

/* Append the ends of a piece's crossing segment, and of a lower piece its middle, a point of the
 * curve: lower pieces on irrational lines are not decided. `first` and `last`: pmc of the ends. */
static void put_crossing(text *t, const outline_piece *p, size_t number, const char *first,
                         const char *last) {
    LOCAL_VEC(fmpq, middle, 2);
    const fmpq *const at[] = {p->sample, middle, p->sample + 2};
    const char *const side[] = {first, "on", last};
    vector_middle(middle, at[0], at[2], 2);
    for (int k = 0; k < 3; k += p->lower ? 1 : 2) {
        text_rational(t, at[k]);
        text_put(t, ",");
        text_rational(t, at[k] + 1);
        text_format(t, p->lower ? ",,%zu,%s\n" : ",%zu,,%s\n", number, side[k]);
    }
}

graze_status outline_samples(text *t, graze_context *context, const graze_outline *o) {
    const char *around = o->scene->options.operation == GRAZE_SWEEP ? "in" : "out";
    size_t lower = 0;
    text_put(t, "x,y,arc,lower,side\n");
    for (size_t k = 0; k < o->arc_count; k++)
        for (size_t i = 0; i < o->arc[k].count; i++)
            put_crossing(t, &o->piece[o->arc_piece[o->arc[k].first + i]], k, "in", "out");
    for (size_t k = 0; k < o->piece_count; k++)
        if (o->piece[k].lower == 1)
            put_crossing(t, &o->piece[k], lower++, around, around);
    return context_poll(context);
}
