/* A grid of square cells in the plane or in a plane of space, each classified at its centre.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The centres are rationals and the classification is exact; nothing is said about the rest of a
 * cell. In E^2 cells at borders are split into parts, each classified at its own centre
 * (cell_parts.h); in E^3 regions have contours between the centres (contour.h).
 */
#ifndef GRAZE_DRAW_CLASS_GRID_H
#define GRAZE_DRAW_CLASS_GRID_H

#include <stdint.h>
#include "decide/scene/scene.h"
#include "output/draw/panel.h"
#include "output/draw/section.h"

/** A grid is drawn wide if its width exceeds its height by more than this factor. */
#define CELLS_WIDE 1.6

/** Bands of the distance on each side. */
enum { BANDS = 6 };

/** Colour of a point: its class for a sweep, its pmc for an unsweep, of a cell also a band of its
 * distance. Zero is none. */
typedef enum tone {
    TONE_NONE = 0, /* undecided too */
    TONE_REGULAR = 1,
    TONE_FOLD = 2,
    TONE_FOLD_BOUNDARY = 3,
    TONE_BOUNDARY = 4,
    TONE_EXTERIOR = 5,
    TONE_IN = 6,
    TONE_ON = 7,
    TONE_OUT = 8,
    TONE_INNER = 9, /* bands of the distance, the nearest first */
    TONE_OUTER = 15,
    TONE_COUNT = 21
} tone;

/** The tone of a verdict. */
tone tone_of(const graze_verdict *v);

/** Cell (i, j) has its centre at low + (i + 1/2, j + 1/2) side. */
typedef struct cells {
    int axis[2]; /* the coordinates along which i and j run */
    size_t count[2];
    fmpq *low;              /* a corner of d coordinates; off the two axes, the plane's place */
    int dimension;          /* 2 with a section, whose u and v they are */
    const section *section; /* borrowed; NULL: the plane of two axes */
    fmpq_t side;
    unsigned char *tone; /* row by row, i running fastest */
    size_t parts;        /* of a split cell along each side, odd; 1: no cell is split */
    uint32_t *split;     /* one a cell: 0, or the number of its block of parts, from 1 */
    size_t split_count;
    unsigned char *part;           /* tones of the parts, block by block, row by row */
    double *distance;              /* of the cells' centres; NULL: not asked */
    double step;                   /* between levels: */
    int step_digit, step_exponent; /* 1, 2, 5 or 10, times this power of ten */
} cells;

/**
 * Lay the grid out: square cells, `longer` of them along the box's longer side, that cover the box
 * evenly.
 * @param[out] out    cleared by cells_clear, also on failure
 * @param low, high   d rationals each, low < high on both axes; the two of another axis have no
 * effect
 * @param longer      0: the number at which a cell has two pixels, with `coarse` four
 * @param plane       the place on the axis that is left, in E^3
 * @return GRAZE_ELIMIT more cells than the limit `grid`
 */
graze_status cells_layout(cells *out, graze_context *context, int dimension, const int axis[2],
                          const fmpq *low, const fmpq *high, const fmpq_t plane,
                          unsigned long longer, int coarse);
void cells_clear(cells *c);

/** The point low + (i, j) side / parts, in room for three rationals. */
void cells_place(fmpq *out, const cells *c, size_t parts, size_t i, size_t j);
/** The tone of that point, classified exactly. */
graze_status cells_ask(tone *out, const cells *c, graze_context *context, const graze_scene *scene,
                       size_t parts, size_t i, size_t j);

/** Classify all centres. */
graze_status cells_classify(cells *c, graze_context *context, const graze_scene *scene);

/** The plane of the cells in E^3, on `axis` or a section's: `z = 3`, `z = 7/2 = 3.5`, a long ratio
 * as a decimal alone. */
void cells_plane(text *out, const cells *c, int axis);
/** Letters of the coordinates along which `axis` counts. */
const char *cells_axes(const cells *c);
/** The rectangle of the plane that the cells cover. */
extent cells_extent(const cells *c);
/** The point of space of two coordinates in the plane of the cells, in E^3. */
void cells_corner(double out[3], const cells *c, double horizontal, double vertical);
/** Add the cells of a tone as rectangles, one for each run of them along a row. */
void cells_path(drawn_path *out, const cells *c, const panel *p, tone t);
/** Add the rectangle of `length` neighbouring cells from (i, j) on, of the grid whose cells are
 * `parts` times as small. */
void cells_rectangle(drawn_path *out, const cells *c, const panel *p, size_t parts, size_t i,
                     size_t j, size_t length);

/** Their layout as attributes of SVG: exact numbers, from which the centres follow. */
void cells_attributes(text *out, const cells *c, const panel *p);

#endif
