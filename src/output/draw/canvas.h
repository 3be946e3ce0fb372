/* A surface to draw on, in pixels from the upper left corner; made of paths, circles and texts.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * There are an SVG text, a PNG image and a page of PDF. Drawing never fails half-way: a failure is
 * kept and returned by canvas_finish.
 */
#ifndef GRAZE_DRAW_CANVAS_H
#define GRAZE_DRAW_CANVAS_H

#include "base/number/text.h"

/** A colour 0xRRGGBB as paint; 0 paints nothing. */
#define PAINT(rgb) (0x1000000u | (rgb))

/** Style of a path or circle. Zeroed it draws nothing. */
typedef struct style {
    unsigned fill, stroke; /* paints */
    double width;          /* of the stroke */
    double dash;           /* length of dashes and gaps; 0: none */
    double faintness;      /* 0 opaque ... 1 invisible */
    int crisp;             /* edges on whole pixels, no smoothing */
} style;

/** Begin a part at a point, go on with a line, or close the part. */
typedef struct path_node {
    char verb; /* M, L or z */
    double x, y;
} path_node;

/** Grows by the functions below; once memory has run short `failed` is set. */
typedef struct drawn_path {
    path_node *node;
    size_t count, capacity;
    int failed;
} drawn_path;

void drawn_path_clear(drawn_path *p);
void drawn_path_to(drawn_path *p, char verb, double x, double y);
/** Add a segment, and a rectangle by two of its corners. */
void drawn_path_line(drawn_path *p, double x0, double y0, double x1, double y1);
void drawn_path_box(drawn_path *p, double x0, double y0, double x1, double y1);

/** Where the text's anchor is: at its start, middle or end. */
typedef enum text_anchor { ANCHOR_START, ANCHOR_MIDDLE, ANCHOR_END } text_anchor;

/** Style of a text, whose colour is dark. */
typedef struct lettering {
    double size;
    text_anchor anchor;
    int bold;
    int halo; /* a light rim, to be legible on anything */
} lettering;

typedef struct canvas canvas;

/** Write the file and free the canvas, or only free it where `write` is 0. NULL is harmless. */
graze_status canvas_finish(canvas *c, graze_context *context, const char *file, int write);

/** A part of the picture with a name and perhaps attributes, `key="value"` in SVG's form. */
void canvas_begin(canvas *c, const char *name, const char *attributes);
void canvas_end(canvas *c);
/** Draw only inside a rectangle until canvas_unclip. */
void canvas_clip(canvas *c, double x, double y, double width, double height);
void canvas_unclip(canvas *c);
/** Draw a path, even-odd, and clear it. `name` is the class of the element, or NULL. */
void canvas_path(canvas *c, drawn_path *p, const style *s, const char *name);
void canvas_circle(canvas *c, double x, double y, double radius, const style *s);
/** A line of UTF-8 on its baseline. Control characters and bytes that are no character become
 * question marks. */
void canvas_text(canvas *c, double x, double y, const lettering *l, const char *string);

/** Bytes of the UTF-8 character at `at`, or 0 if there is none that XML takes. */
size_t canvas_character(const char *at);
/** Width of a text in pixels, for fonts as wide as DejaVu Sans. */
double canvas_text_width(const char *string, double size);

/* ---------------------------------------------------------------------------- the two kinds */

/** Takes bytes; 0 without memory. */
typedef int canvas_put(void *to, const char *bytes, size_t length);

typedef struct canvas_kind {
    void (*begin)(canvas *c, const char *name, const char *attributes);
    void (*end)(canvas *c);
    void (*clip)(canvas *c, double x, double y, double width, double height);
    void (*unclip)(canvas *c);
    void (*path)(canvas *c, const drawn_path *p, const style *s, const char *name);
    void (*circle)(canvas *c, double x, double y, double radius, const style *s);
    void (*text)(canvas *c, double x, double y, const lettering *l, const char *string);
    /* Hand the file's bytes over, unless the canvas has failed. */
    void (*finish)(canvas *c, canvas_put *put, void *to);
    void (*destroy)(canvas *c);
} canvas_kind;

/** Each kind's own struct begins with this. */
struct canvas {
    const canvas_kind *kind;
    double width, height;
    int failed; /* memory ran short */
};

/** Dark ink, used for texts. */
#define INK 0x222222u

/** Write bytes into a file, or, for `-.svg` and other names that are `-` and an ending, to standard
 * output. @return GRAZE_ESYSTEM */
graze_status save_file(graze_context *context, const char *file, const text *bytes);

#endif
