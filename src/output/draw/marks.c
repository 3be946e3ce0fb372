/* Colours, signs, the legend.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/views.h"

#include "base/context/scope.h"

enum { SLIDE = 0xcc79a7 };

static const struct {
    const char *name;
    unsigned colour;
} tones[TONE_COUNT] = {{"undecided", 0xffffff}, {"regular", 0x56b4e9},
                       {"fold", 0xe69f00},      {"fold_boundary", 0x009e73},
                       {"boundary", 0xd55e00},  {"exterior", 0xffffff},
                       {"in", 0x56b4e9},        {"on", 0xd55e00},
                       {"out", 0xffffff},       {"inner-1", 0xc6e2f5},
                       {"inner-2", 0x93c6e8},   {"inner-3", 0x5aa5d6},
                       {"inner-4", 0x2b80ba},   {"inner-5", 0x0f5c94},
                       {"inner-6", 0x063a63},   {"outer-1", 0xfff3d6},
                       {"outer-2", 0xfde0a3},   {"outer-3", 0xf5c566},
                       {"outer-4", 0xe6a12e},   {"outer-5", 0xbd7a10},
                       {"outer-6", 0x855207}};

const style outline_start = {.stroke = PAINT(INK), .width = 2};
const style outline_end = {.stroke = PAINT(INK), .width = 2, .dash = 5};
const style outline_between = {.stroke = PAINT(0x666666), .width = .8};
const style arc_style[] = {{.stroke = PAINT(0x0072b2), .width = 1.6},
                           {.stroke = PAINT(0xd55e00), .width = 1.6},
                           {.stroke = PAINT(SLIDE), .width = 1.6}};
const style outline_plane = {.stroke = PAINT(0x0072b2), .width = 1.2, .dash = 6};
const style trail_outside = {.stroke = PAINT(INK), .width = 1};
const style trail_inside = {.stroke = PAINT(INK), .width = 2.4};
const style trail_sliding = {.stroke = PAINT(SLIDE), .width = 5};

const style line_level = {.stroke = PAINT(0x444444), .width = .7};
const style line_border = {.stroke = PAINT(0xd55e00), .width = 3};

unsigned tone_colour(tone t) {
    return tones[t].colour;
}

const char *tone_name(tone t) {
    return tones[t].name;
}

unsigned mark_colour(size_t k) {
    static const unsigned colours[] = {0x0072b2, 0xe69f00, 0x009e73, 0xcc79a7, 0x56b4e9};
    return colours[k % (sizeof colours / sizeof *colours)];
}

void mark_point(canvas *c, double x, double y, double radius, tone t) {
    const style disk = {.fill = PAINT(tone_colour(t)), .stroke = PAINT(INK), .width = 1.4};
    c->kind->circle(c, x, y, radius, &disk);
}

/* Draw a circle for a face, a square for an edge, a triangle for a vertex; contacts have size 1. */
static void put_sign(canvas *c, double x, double y, double size, graze_cell_kind cell,
                     const style *s) {
    static const double corners[2][4][2] = {{{-3.6, -3.6}, {3.6, -3.6}, {3.6, 3.6}, {-3.6, 3.6}},
                                            {{0, -5.4}, {5, 3.4}, {-5, 3.4}}};
    drawn_path sign = {NULL, 0, 0, 0};
    if (cell == GRAZE_CELL_FACE) {
        c->kind->circle(c, x, y, 4 * size, s);
        return;
    }
    for (int k = 0; k < (cell == GRAZE_CELL_EDGE ? 4 : 3); k++) {
        const double *corner = corners[cell != GRAZE_CELL_EDGE][k];
        drawn_path_to(&sign, k ? 'L' : 'M', x + size * corner[0], y + size * corner[1]);
    }
    drawn_path_to(&sign, 'z', 0, 0);
    canvas_path(c, &sign, s, NULL);
}

void mark_contact(canvas *c, double x, double y, graze_kind kind, graze_cell_kind cell) {
    static const style styles[] = {
        {.fill = PAINT(SLIDE), .stroke = PAINT(INK), .width = .8},
        [GRAZE_INTERSECTION] = {.fill = PAINT(INK), .stroke = PAINT(0xffffff), .width = .8},
        [GRAZE_TANGENCY] = {.fill = PAINT(0xffffff), .stroke = PAINT(0xd55e00), .width = 1.8}};
    put_sign(c, x, y, kind ? 1 : .8, cell, &styles[kind]);
}

/* put_legend both draws the legend and measures it: without a canvas it only advances y. */
typedef struct writer {
    canvas *canvas;
    double x, y;
} writer;

enum { LINE = 20, SIGN = 34 };

typedef struct legend_line {
    const char *name;
    const style *style;
} legend_line;

static void put_heading(writer *w, const char *text) {
    const lettering heading = {.size = 12, .bold = 1};
    w->y += LINE * 1.2;
    if (w->canvas)
        canvas_text(w->canvas, w->x, w->y, &heading, text);
}

static void put_legend_entry(writer *w, const char *text) {
    const lettering plain = {.size = 12};
    w->y += LINE;
    if (w->canvas)
        canvas_text(w->canvas, w->x + SIGN, w->y, &plain, text);
}

static void put_swatch(writer *w, tone t, const char *name) {
    const style area = {
        .fill = PAINT(tone_colour(t)), .stroke = PAINT(0x888888), .width = 1, .crisp = 1};
    put_legend_entry(w, name);
    if (!w->canvas)
        return;
    drawn_path box = {NULL, 0, 0, 0};
    drawn_path_box(&box, w->x, w->y - 11, w->x + 26, w->y + 2);
    canvas_path(w->canvas, &box, &area, NULL);
}

static void put_legend_line(writer *w, const style *s, const char *text) {
    put_legend_entry(w, text);
    if (!w->canvas)
        return;
    drawn_path line = {NULL, 0, 0, 0};
    drawn_path_line(&line, w->x, w->y - 4, w->x + 26, w->y - 4);
    canvas_path(w->canvas, &line, s, NULL);
}

/* Put the lines of ends of slides, then those of contacts, into the legend. */
static void put_contacts(writer *w, const legend *l) {
    static const char *const names[3][4] = {
        {NULL, "end of a slide, face", "end of a slide, edge", "end of a slide, vertex"},
        {NULL, "intersection, face", "intersection, edge", "intersection, vertex"},
        {NULL, "tangency, face", "tangency, edge", "tangency, vertex"}};
    for (int k = 0, some = 0; k < 12; k++) {
        int kind = k / 4, cell = k % 4;
        if (!l->contacts[kind][cell])
            continue;
        if (kind && !some++)
            put_heading(w, "Contacts");
        put_legend_entry(w, names[kind][cell]);
        if (w->canvas)
            mark_contact(w->canvas, w->x + 13, w->y - 4, (graze_kind)kind, (graze_cell_kind)cell);
    }
}

static void put_band(writer *w, const legend *l, tone t) {
    HELD(text, band);
    if (!l->tones[t])
        return;
    band_put(&band, l->cells, t);
    put_swatch(w, t, band.failed ? "" : band.data);
    if (w->canvas)
        w->canvas->failed |= band.failed;
}

/* Put the scale of distances into the legend, from the deepest band inside to the farthest outside.
 */
static void put_scale(writer *w, const legend *l) {
    put_heading(w, "Signed distance");
    for (int t = TONE_OUTER - 1; t >= TONE_INNER; t--)
        put_band(w, l, (tone)t);
    if (l->tones[TONE_ON])
        put_swatch(w, TONE_ON, "0");
    for (int t = TONE_OUTER; t < TONE_COUNT; t++)
        put_band(w, l, (tone)t);
    put_legend_line(w, &line_border, "border of the set");
    put_legend_line(w, &line_level, "level");
}

/* Put the classes into the legend; for an unsweep the answers. */
static void put_classes(writer *w, const legend *l) {
    int unsweep = l->tones[TONE_IN] || l->tones[TONE_ON] || l->tones[TONE_OUT], some = 0;
    int last = l->cells ? TONE_EXTERIOR : TONE_OUT;
    for (int t = TONE_REGULAR; t <= last; t++)
        some |= l->tones[t];
    if (some)
        put_heading(w, l->cells ? "Class of points" : unsweep ? "Unsweep" : "Class");
    for (int t = TONE_REGULAR; t <= last; t++)
        if (l->tones[t])
            put_swatch(w, (tone)t, tone_name((tone)t));
}

/* Put the rows of the lines that the picture has into the legend, under a heading if there are any.
 */
static void put_lines(writer *w, const char *heading, const int *shown, const legend_line *line) {
    for (int k = 0, some = 0; line[k].name; k++) {
        if (!shown[k])
            continue;
        if (!some++)
            put_heading(w, heading);
        put_legend_line(w, line[k].style, line[k].name);
    }
}

static void put_legend(writer *w, const legend *l) {
    static const legend_line positions[] = {{"at the start", &outline_start},
                                            {"between", &outline_between},
                                            {"at the end", &outline_end},
                                            {"plane of the cells", &outline_plane},
                                            {NULL, NULL}};
    static const legend_line arcs[] = {{"path of a vertex", &arc_style[SOURCE_PATH]},
                                       {"edge at one time", &arc_style[SOURCE_EDGE]},
                                       {"envelope of an edge", &arc_style[SOURCE_ENVELOPE]},
                                       {NULL, NULL}};
    static const legend_line spans[] = {{"outside S", &trail_outside},
                                        {"inside S", &trail_inside},
                                        {"sliding on S", &trail_sliding},
                                        {NULL, NULL}};
    if (l->cells)
        put_scale(w, l);
    put_classes(w, l);
    put_lines(w, "Boundary, exact", l->sources, arcs);
    put_lines(w, "Positions of S", l->positions, positions);
    put_lines(w, "Trajectories", l->spans, spans);
    put_contacts(w, l);
}

void legend_draw(canvas *c, const legend *l, double x, double y) {
    writer w = {c, x, y - LINE * 1.2 + 10};
    put_legend(&w, l);
}

double legend_height(const legend *l) {
    writer w = {NULL, 0, 0};
    put_legend(&w, l);
    return w.y;
}
