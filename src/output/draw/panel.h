/* Panels of a picture: trails, sections, cells, solids.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_OUTPUT_DRAW_PANEL_H
#define GRAZE_OUTPUT_DRAW_PANEL_H

#include <stddef.h>
#include <stdint.h>
#include "output/draw/draw.h"

/* One frame of a picture: a window on a plane onto which points are projected. */

/** The plane of two coordinate axes. */
projection projection_of_axes(int horizontal, int vertical);
/** The view from a direction, with z upwards (y upwards if the direction is along z).
 * @param from not zero */
projection projection_from(const double from[3]);
/** Coordinate k of a point's image. */
double projection_at(const projection *p, int k, const double point[3]);

extent extent_empty(void);
void extent_add(extent *e, double x, double y);
/** Grow to all sides. */
void extent_grow(extent *e, double by);

typedef struct panel {
    projection look;
    extent window;
    double scale;               /* pixels per unit */
    double x, y, width, height; /* of the frame, in pixels */
    double left;                /* pixels for the numbers on the left of the frame */
    char title[96];             /* text over the frame */
} panel;

/** The smallest step that is at least `least`. */
tick_step step_for(double least);

/** The largest panel of a window whose frame is at most `longest` and at least a quarter of that in
 * width and height. The panel is at the canvas's origin. */
panel panel_fit(const projection *look, const extent *window, double longest);
/** The pixel of a point of three coordinates. */
void panel_map(double *x, double *y, const panel *p, const double point[3]);

/** Find the part of the segment between two pixels that lies in the frame, as shares of the
 * segment; 0 if there is none. */
int panel_clip_segment(double share[2], const panel *p, const double from[2], const double to[2]);
/** 1 if a pixel lies in the frame. */
int panel_holds(const panel *p, double x, double y);
/** 1 if a part of a line through pixels lies in the frame. */
int panel_shows(const panel *p, const drawn_path *line);

/** Room above and below the frame; `left` of a panel is the room on the left. */
enum { PANEL_ABOVE = 26, PANEL_BELOW = 24 };

/** Give a panel its title, and room on the left: if `numbered`, for the numbers of panel_frame. */
void panel_name(panel *p, const char *title, int numbered);
/** The width of the frame or of its title, whichever is larger. */
double panel_span(const panel *p);
/** Draw the frame with its title above, numbers along the left and the lower side, and the names of
 * the two axes. In space (`axes` NULL) a scale bar of a round length in the lower right corner and
 * small arrows along the axes x, y, z replace numbers and names.
 * @param axes two letters */
void panel_frame(canvas *c, const panel *p, const char *axes);

/** Draw an arrow's head with its tip at a pixel. It points along (dx, dy), which is not zero. */
void draw_arrow_head(canvas *c, double x, double y, double dx, double dy, double size);

/* An oblique plane of space, with coordinates u and v.
 *
 * Its points are origin + u way[0] + v way[1], with rational entries, so that they are exact. The
 * origin is the plane's point nearest to the origin of space; way[0] is horizontal, and
 * way[1] is the cross product of the normal and way[0], pointing upwards unless the normal is
 * vertical. They are orthogonal, and their lengths differ from 1 by at most 2^-50, since exact
 * lengths would not be rational. */

/** @param out    uninitialised; section_clear frees it in any case
 * @param normal three rationals, not all 0 */
void section_make(section *out, const fmpq *normal, const fmpq_t place);

/** The point of u and v, three rationals. */
void section_point(fmpq *out, const section *s, const fmpq *uv);
/** 1 if a point lies in the plane. */
int section_holds(const section *s, const fmpq *point);
/** Find a rectangle, only slightly too large, that holds the part of the plane in a box; 0 if the
 * plane has no point inside the box.
 * @param[out] low, high u and v each
 * @param box_low, box_high three rationals each */
int section_extent(fmpq *low, fmpq *high, const section *s, const fmpq *box_low,
                   const fmpq *box_high);

/** Append the plane's equation, as x + 2*y - 1/2*z = 3. */
void section_equation(text *out, const section *s);
/** Append origin and ways in rounded decimals or, if `exact`, in exact numbers as SVG attributes.
 */
void section_describe(text *out, const section *s, int exact);

/* A grid of square cells in the plane or in a plane of space, each classified at its centre.
 *
 * The centres are rationals and their classification is exact; the rest of a cell is not examined.
 * In E^2 cells at borders are split into parts, each classified at its own centre (draw.h); in E^3
 * regions have contours between the centres (views.h). */

/** A grid is drawn wide if its width exceeds its height by more than this factor. */
#define CELLS_WIDE 1.6

/** Number of bands of the distance inside the set, and outside. */
enum { BANDS = 6 };

/**
 * Lay the grid out: square cells, `longer` of them along the box's longer side, that cover the box
 * evenly.
 * @param[out] out    cleared by cells_clear, also on failure
 * @param low, high   d rationals each, low < high on both axes; the coordinate on the third axis
 * has no effect
 * @param longer      0: the number at which a cell has two pixels, or four if `coarse`
 * @param plane       in E^3 the plane's coordinate on the third axis
 * @return GRAZE_ELIMIT more cells than the limit `grid`
 */
graze_status cells_layout(cells *out, graze_context *context, int dimension, const int axis[2],
                          const fmpq *low, const fmpq *high, const fmpq_t plane,
                          unsigned long longer, int coarse);

/** The point low + (i, j) side / parts, in room for three rationals. */
void cells_place(fmpq *out, const cells *c, size_t parts, size_t i, size_t j);
/** The tone of the point of cells_place, classified exactly. */
graze_status cells_ask(tone *out, const cells *c, graze_context *context, const graze_scene *scene,
                       size_t parts, size_t i, size_t j);

/** Classify all centres. */
graze_status cells_classify(cells *c, graze_context *context, const graze_scene *scene);
/** Letters of the two coordinates along which the cells run. */
const char *cells_axes(const cells *c);
/** Add the cells of a tone as rectangles, one for each run of cells along a row. If `parts`, the
 * number of parts along each side of a split cell, is more than 1, add instead the parts that have
 * the tone in cells of another tone. */
void cells_path(drawn_path *out, const cells *c, const panel *p, size_t parts, tone t);

/** Append the cells' layout as SVG attributes: exact numbers, from which the centres follow. */
void cells_attributes(text *out, const cells *c, const panel *p);

/* Lines in which the boundary of a solid meets a plane, chained from triangle to triangle. */

/** A segment in pixels; each end lies on an edge, whose key the neighbouring triangle has too. */
typedef struct chain_segment {
    uint64_t key[2];
    double x[2], y[2];
} chain_segment;

/** Chain segments with equal keys into lines, closed where a line returns to its first segment, and
 * add the lines.
 * @param apart the least distance in pixels of two nodes of a line */
void chain_path(drawn_path *out, const chain_segment *segments, size_t count, double apart);

/* A curved solid in doubles: whether a place is in it, and the normal of its boundary.
 *
 * It serves pictures alone and decides nothing. */
/** The expression of a solid, prepared for evaluation at places by one thread at a time. The solid
 * is borrowed. */
typedef struct eye_field {
    const csg *solid;
    double *coefficient; /* of all surfaces, one after another */
    signed char *sign, *other;
    uint64_t *truth;
} eye_field;

/** Prepare a field. Cleared by eye_field_clear, also on failure. */
graze_status eye_field_make(eye_field *out, graze_context *context, const csg *solid);
void eye_field_clear(eye_field *field);

/** Does the expression hold at a place? `at` has a coordinate for each dimension of the solid. */
int eye_field_holds(eye_field *field, const double *at);

/** The unit normal of the boundary between two near places, one of them in the solid: the normal of
 * the first surface between them, 0 if there is none. It points from `from` to `to`.
 * @param step a length that is small compared with the picture's details */
void eye_field_normal(double out[3], eye_field *field, const double *from, const double *to,
                      double step);

/* The boundary of a curved solid of the plane, as segments made for the eye (draw.h). */

/** Add vertices and segments to an empty solid of the plane. */
graze_status eye_outline_make(graze_solid *out, graze_context *context, const csg *solid);

/* The trajectory of a query point, cut at its contacts, as lines of a picture.
 *
 * States, contacts and their cells are those of the exact trace; only the places that are drawn
 * are rounded. */

/** A stretch of one state: places first ... first + count - 1. Its first place equals the last
 * place of the stretch before it. */
typedef struct trail_span {
    graze_state state;
    size_t first, count;
} trail_span;

typedef struct trail_contact {
    graze_kind kind;
    graze_cell_kind cell; /* kind of the touched cell: at an instant of the cell of least dimension,
                     for an interval of the cell of greatest dimension */
    double at[3];         /* place of the contact; for an interval the middle of its drawn places */
    int lasts;            /* 1: the contact is an interval, with the ends below */
    graze_cell_kind end_cell[2];
    double end[2][3];
} trail_contact;

typedef struct trail {
    tone tone;
    double *at; /* places, three coordinates each */
    size_t place_count, place_capacity;
    trail_span *span;
    size_t span_count;
    trail_contact *contact;
    size_t contact_count;
} trail;

/**
 * Trace a point and follow its trajectory: the inverted one for a sweep, the forward one for an
 * unsweep.
 * @param[out] out cleared by trail_clear, also on failure
 * @param fineness greatest distance of the lines from the curve
 */
graze_status trail_make(trail *out, graze_context *context, const graze_scene *scene,
                        const fmpq *point, double fineness);
void trail_clear(trail *c);

/** The extent of the part of the curve's image that lies in a rectangle. */
void trail_extent(extent *out, const trail *c, const projection *look, const extent *within);

#endif
