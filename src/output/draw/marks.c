/* Colours, signs, the legend.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/marks.h"

static const struct {
    const char *name;
    unsigned colour;
} tones[TONE_COUNT] = {{"undecided", 0xffffff}, {"regular", 0x56b4e9},
                       {"fold", 0xe69f00},      {"fold_boundary", 0x0072b2},
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
const style outline_plane = {.stroke = PAINT(0x009e73), .width = 1.2, .dash = 6};
const style trail_outside = {.stroke = PAINT(INK), .width = 1};
const style trail_inside = {.stroke = PAINT(INK), .width = 2.4};
const style trail_sliding = {.stroke = PAINT(0xcc79a7), .width = 5};

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
    canvas_circle(c, x, y, radius, &disk);
}

void mark_contact(canvas *c, double x, double y, graze_kind kind, graze_cell_kind cell) {
    const style full = {.fill = PAINT(INK), .stroke = PAINT(0xffffff), .width = .8};
    const style hollow = {.fill = PAINT(0xffffff), .stroke = PAINT(0xd55e00), .width = 1.8};
    const style *s = kind == GRAZE_INTERSECTION ? &full : &hollow;
    drawn_path sign = {NULL, 0, 0, 0};
    if (cell == GRAZE_CELL_FACE) {
        canvas_circle(c, x, y, 4, s);
    } else if (cell == GRAZE_CELL_EDGE) {
        drawn_path_to(&sign, 'M', x - 3.6, y - 3.6);
        drawn_path_to(&sign, 'L', x + 3.6, y - 3.6);
        drawn_path_to(&sign, 'L', x + 3.6, y + 3.6);
        drawn_path_to(&sign, 'L', x - 3.6, y + 3.6);
    } else {
        drawn_path_to(&sign, 'M', x, y - 5.4);
        drawn_path_to(&sign, 'L', x + 5, y + 3.4);
        drawn_path_to(&sign, 'L', x - 5, y + 3.4);
    }
    drawn_path_to(&sign, 'z', 0, 0);
    if (cell != GRAZE_CELL_FACE)
        canvas_path(c, &sign, s, NULL);
    drawn_path_clear(&sign);
}

/* The legend is laid out once; without a canvas it is only measured. */
typedef struct writer {
    canvas *canvas;
    double x, y;
} writer;

enum { LINE = 20, SIGN = 34 };

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
    drawn_path_to(&box, 'M', w->x, w->y - 11);
    drawn_path_to(&box, 'L', w->x + 26, w->y - 11);
    drawn_path_to(&box, 'L', w->x + 26, w->y + 2);
    drawn_path_to(&box, 'L', w->x, w->y + 2);
    drawn_path_to(&box, 'z', 0, 0);
    canvas_path(w->canvas, &box, &area, NULL);
    drawn_path_clear(&box);
}

static void put_legend_line(writer *w, const style *s, const char *text) {
    put_legend_entry(w, text);
    if (!w->canvas)
        return;
    drawn_path line = {NULL, 0, 0, 0};
    drawn_path_to(&line, 'M', w->x, w->y - 4);
    drawn_path_to(&line, 'L', w->x + 26, w->y - 4);
    canvas_path(w->canvas, &line, s, NULL);
    drawn_path_clear(&line);
}

static void put_contacts(writer *w, const legend *l) {
    static const char *const names[3][4] = {
        {NULL, NULL, NULL, NULL},
        {NULL, "intersection, face", "intersection, edge", "intersection, vertex"},
        {NULL, "tangency, face", "tangency, edge", "tangency, vertex"}};
    int some = 0;
    for (int kind = GRAZE_INTERSECTION; kind <= GRAZE_TANGENCY; kind++)
        for (int cell = GRAZE_CELL_FACE; cell <= GRAZE_CELL_VERTEX; cell++) {
            if (!l->contacts[kind][cell])
                continue;
            if (!some++)
                put_heading(w, "Contacts");
            put_legend_entry(w, names[kind][cell]);
            if (w->canvas)
                mark_contact(w->canvas, w->x + 13, w->y - 4, (graze_kind)kind,
                             (graze_cell_kind)cell);
        }
}

/* The scale of distances, from the deepest band inside to the farthest outside. */
static void put_scale(writer *w, const legend *l) {
    put_heading(w, "Signed distance");
    for (int t = TONE_OUTER - 1; t >= TONE_INNER; t--)
        if (l->tones[t])
            put_swatch(w, (tone)t, l->band[t - TONE_INNER]);
    if (l->tones[TONE_ON])
        put_swatch(w, TONE_ON, "0");
    for (int t = TONE_OUTER; t < TONE_COUNT; t++)
        if (l->tones[t])
            put_swatch(w, (tone)t, l->band[t - TONE_INNER]);
    put_legend_line(w, &line_border, "between in, on, out");
    put_legend_line(w, &line_level, "level");
}

/* Classes, and for an unsweep answers. */
static void put_classes(writer *w, const legend *l) {
    int unsweep = l->tones[TONE_IN] || l->tones[TONE_ON] || l->tones[TONE_OUT], some = 0;
    int last = l->by_distance ? TONE_EXTERIOR : TONE_OUT;
    for (int t = TONE_REGULAR; t <= last; t++)
        some |= l->tones[t];
    if (some)
        put_heading(w, l->by_distance ? "Class of points" : unsweep ? "Unsweep" : "Class");
    for (int t = TONE_REGULAR; t <= last; t++)
        if (l->tones[t])
            put_swatch(w, (tone)t, tone_name((tone)t));
}

static void put_legend(writer *w, const legend *l) {
    if (l->by_distance)
        put_scale(w, l);
    put_classes(w, l);
    put_heading(w, "Positions of S");
    put_legend_line(w, &outline_start, "at the start");
    if (!l->by_distance)
        put_legend_line(w, &outline_between, "between");
    put_legend_line(w, &outline_end, "at the end");
    if (l->plane)
        put_legend_line(w, &outline_plane, "plane of the cells");
    if (l->trails) {
        put_heading(w, "Trajectories");
        put_legend_line(w, &trail_outside, "outside S");
        put_legend_line(w, &trail_inside, "inside S");
        if (l->slides)
            put_legend_line(w, &trail_sliding, "sliding on S");
    }
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
