/* One frame of a picture: a window on a plane onto which points are projected.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_PANEL_H
#define GRAZE_DRAW_PANEL_H

#include "output/draw/canvas.h"

/** Two rows that take a point to the coordinates of the picture's plane. In E^2 the third
 * coordinate of every point is 0. */
typedef struct projection {
    double row[2][3];
} projection;

/** The plane of two coordinate axes. */
projection projection_of_axes(int horizontal, int vertical);
/** The view from a direction, z (or y, where the direction is along z) upwards.
 * @param from not zero */
projection projection_from(const double from[3]);
/** Coordinate k of a point's image. */
double projection_at(const projection *p, int k, const double point[3]);

/** A rectangle of the plane that holds what was put into it. */
typedef struct extent {
    double low[2], high[2];
} extent;

extent extent_empty(void);
void extent_add(extent *e, double x, double y);
/** Grow to all sides. */
void extent_grow(extent *e, double by);

typedef struct panel {
    projection look;
    extent window;
    double scale;               /* pixels per unit */
    double x, y, width, height; /* of the frame, in pixels */
    double left;                /* pixels for the numbers on its left */
    char title[96];             /* over the frame */
} panel;

/** The largest panel of a window whose frame is no wider and no higher than `longest` and at least
 * a quarter of it either way; it stands at the canvas's origin. */
panel panel_fit(const projection *look, const extent *window, double longest);
/** The pixel of a point of three coordinates. */
void panel_map(double *x, double *y, const panel *p, const double point[3]);
/** The pixel of a point of the plane. */
void panel_map_plane(double *x, double *y, const panel *p, double horizontal, double vertical);

/** The part of the segment between two pixels that lies in the frame, as shares of it; 0 if there
 * is none. */
int panel_clip_segment(double share[2], const panel *p, const double from[2], const double to[2]);
/** 1 if a pixel lies in the frame. */
int panel_holds(const panel *p, double x, double y);
/** 1 if some segment of a line through pixels does in part. */
int panel_shows(const panel *p, const drawn_path *line);

/** Room above and below the frame; that on its left is `left`. */
enum { PANEL_ABOVE = 26, PANEL_BELOW = 24 };

/** Give a panel its title, and room on the left, where `numbered` for those of panel_ticks. */
void panel_name(panel *p, const char *title, int numbered);
/** The width of the frame or of its title, whichever is more. */
double panel_span(const panel *p);
/** The frame and the title over it. */
void panel_frame(canvas *c, const panel *p);
/** Numbers along the left and the lower side, and the names of the two axes. */
void panel_ticks(canvas *c, const panel *p, char horizontal, char vertical);
/** A bar of a round length with its number, in the lower right corner. */
void panel_scale_bar(canvas *c, const panel *p);
/** Small arrows that show how the axes x, y, z lie. */
void panel_triad(canvas *c, const panel *p);

/** Draw an arrow's head with its tip at a pixel. (dx, dy) is where it points, not zero. */
void draw_arrow_head(canvas *c, double x, double y, double dx, double dy, double size);

/** Can doubles hold a box of `count` coordinates, and differences in it to less than a pixel?
 * @return GRAZE_ELIMIT if not */
graze_status range_check(graze_context *context, const double *low, const double *high, int count);

#endif
