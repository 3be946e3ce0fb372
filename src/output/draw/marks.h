/* The colours and signs of a picture, and the legend that explains those that were used.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The colours are of Okabe and Ito's palette (Color Universal Design, 2008), which is made to be
 * told apart by the colour-blind; the areas that meet most often differ in lightness too.
 */
#ifndef GRAZE_DRAW_MARKS_H
#define GRAZE_DRAW_MARKS_H

#include "output/draw/class_grid.h"

/** The colour 0xRRGGBB of a tone and its name in the tables. */
unsigned tone_colour(tone t);
const char *tone_name(tone t);

/** The colour 0xRRGGBB of thing k among several, from the same palette without that of `on`; they
 * begin again after some. */
unsigned mark_colour(size_t k);

/** A query point: a disk in its colour. A larger one stays to be seen under a contact. */
void mark_point(canvas *c, double x, double y, double radius, tone t);
enum { MARK_RADIUS = 5, MARK_LARGE = 8 };
/** A contact: full for an intersection, hollow for a tangency, small in the colour of sliding for
 * kind 0, the end of a slide; a circle on a face, a square on an edge, a triangle on a vertex. */
void mark_contact(canvas *c, double x, double y, graze_kind kind, graze_cell_kind cell);
/** Outlines of S at the start, at the end and between. */
extern const style outline_start, outline_end, outline_between;
/** Level lines of the distance, and the border between cells of different answers. */
extern const style line_level, line_border;
/** The rectangle of the cells, seen in space. */
extern const style outline_plane;
/** A trajectory outside, inside and on the boundary of S. */
extern const style trail_outside, trail_inside, trail_sliding;

/** Contents of a picture that can be seen, for its legend. */
typedef struct legend {
    int tones[TONE_COUNT];
    int by_distance;
    char band[TONE_COUNT - TONE_INNER][64]; /* distances of bands */
    int positions[4];   /* at the start, between, at the end; the plane of the cells */
    int spans[3];       /* of trajectories, outside S, inside, sliding on it */
    int contacts[3][4]; /* by kind and cell, of kind 0 ends of slides */
} legend;

/** Draw the legend from (x, y) on. */
void legend_draw(canvas *c, const legend *l, double x, double y);
/** Height of the legend in pixels. */
double legend_height(const legend *l);
enum { LEGEND_WIDTH = 190 };

#endif
