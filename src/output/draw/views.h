/* The views of a picture: its lines, shapes, labels, marks and legend, and the kinds of canvas.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_OUTPUT_DRAW_VIEWS_H
#define GRAZE_OUTPUT_DRAW_VIEWS_H

#include "base/number/text.h"
#include "decide/scene/scene.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "output/draw/draw.h"
#include "output/draw/panel.h"

/* Paths, and drawing on a canvas (draw.h). */

void drawn_path_clear(drawn_path *p);
void drawn_path_to(drawn_path *p, char verb, double x, double y);
/** Add a segment, and a rectangle by two of its corners. */
void drawn_path_line(drawn_path *p, double x0, double y0, double x1, double y1);
void drawn_path_box(drawn_path *p, double x0, double y0, double x1, double y1);

/** Write the file and free the canvas, or only free it where `write` is 0. NULL is harmless. */
graze_status canvas_finish(canvas *c, graze_context *context, const char *file, int write);

/** A part of the picture with a name and perhaps attributes, `key="value"` in SVG's form. */
void canvas_begin(canvas *c, const char *name, const char *attributes);
void canvas_end(canvas *c);
/** Draw a path, even-odd, and clear it. `name` is the class of the element, or NULL. */
void canvas_path(canvas *c, drawn_path *p, const style *s, const char *name);
/** A line of UTF-8 on its baseline. Control characters and bytes that are no character become
 * question marks. */
void canvas_text(canvas *c, double x, double y, const lettering *l, const char *string);
/** Width of a text in pixels, for fonts as wide as DejaVu Sans. */
double canvas_text_width(const char *string, double size);

/* Contours between points of a grid, found by bisection of exact classifications. */

/** Parts of a pixel to which a contour's nodes are exact. */
enum { CONTOUR_FINENESS = 32 };

/**
 * Add the region of the points of the set (in or on) whose tone is `least` or one after it, as
 * closed polygons: marching squares between the cells' centres. A node is the middle of an interval
 * on a square's side, at most 1 / CONTOUR_FINENESS of a pixel long, with one end in the region. The
 * middle of a square of four nodes is classified to tell which are neighbours. Undecided points are
 * outside. Beyond the outermost centres lines go straight on to the frame.
 * @param scene NULL: the region of distances below `level`, interpolated between the centres
 */
graze_status contour_path(drawn_path *out, graze_context *context, const graze_scene *scene,
                          const cells *c, const panel *p, tone least, double level);

/* Names of points, placed so that none covers another or a marker. */

/** A rectangle of pixels that names keep off. */
typedef struct obstacle {
    double x, y, width, height;
    enum { OBSTACLE_LINE, OBSTACLE_MARK, OBSTACLE_NAME } kind; /* no line may cross a name */
} obstacle;

/** An obstacle in one bin, and the bin's next link. Numbers count from 1; 0 ends the chain. */
typedef struct obstacle_link {
    size_t item, next;
} obstacle_link;

enum { LABEL_BINS = 64 };

/** The obstacles of one panel, each in every bin that it meets; those outside are left out, since
 * names stand inside. Once memory has run short `failed` is set. */
typedef struct labels {
    const panel *panel;
    obstacle *item;
    obstacle_link *link;
    size_t count, capacity, link_count, link_capacity;
    size_t first[LABEL_BINS][LABEL_BINS]; /* by row and column */
    unsigned left_out; /* names for which there was no room, counted by the caller */
    int failed;
} labels;

void labels_init(labels *l, const panel *p, int has_scale_bar);
void labels_clear(labels *l);
/** Keep off a disk, such as a marker. */
void labels_avoid(labels *l, double x, double y, double radius);
/** 1 if a square of half the side `radius` about a pixel meets a disk that was kept free. */
int labels_meet_mark(const labels *l, double x, double y, double radius);
/** Keep off a line through pixels. */
void labels_avoid_path(labels *l, const drawn_path *p);
/** A place to be named. */
typedef struct labelled_point {
    double x, y;  /* a pixel of the panel */
    double sign;  /* radius of the sign that stands there; 0: none */
    double reach; /* how far away the name may stand */
} labelled_point;
enum { REACH_NEAR = 24, REACH_FAR = 124 };

/** Write a name beside a place, where it is free, with a thin line to the place if the name is not
 * next to it. The name is an obstacle from then on. Returns 0 where nothing is free. */
int labels_place(labels *l, canvas *c, labelled_point at, const char *name);
/** Write the number of names that were left out, if any were, over the panel's right corner. */
void labels_tell(const labels *l, canvas *c);

/* The signed distances of cells: their bands of colour, level lines and the border of the set.
 *
 * The side of a cell's centre is exact. Its distance is within 1/64 of the cell's side. */

/** The distances of a band, such as `-2 to -1`. */
void band_put(text *out, const cells *c, tone t);

/* The colours and signs of a picture, and the legend that explains those that were used.
 *
 * The colours are of Okabe and Ito's palette (Color Universal Design, 2008), which is made to be
 * told apart by the colour-blind; the areas that meet most often differ in lightness too. */

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

/** Things that a picture shows, for its legend: flags, but for `cells`. */
typedef struct legend {
    int tones[TONE_COUNT];
    const cells *cells; /* coloured by distance; NULL: by class */
    int positions[4];   /* at the start, between, at the end; the plane of the cells */
    int spans[3];       /* of trajectories, outside S, inside, sliding on it */
    int contacts[3][4]; /* by kind and cell, of kind 0 ends of slides */
} legend;

/** Draw the legend from (x, y) on. */
void legend_draw(canvas *c, const legend *l, double x, double y);
/** Height of the legend in pixels. */
double legend_height(const legend *l);
enum { LEGEND_WIDTH = 190 };

/* The kind of a picture, by the extension of its file. */
/** Check before long work that canvas_create can make the picture: GRAZE_EUSE an extension other
 * than .svg, .png and .pdf, GRAZE_ESYSTEM no library for the last two. */
graze_status canvas_check(graze_context *context, const char *file);
/** The kind of a path's extension; what canvas_check returns, or GRAZE_ESYSTEM. */
graze_status canvas_create(canvas **out, graze_context *context, const char *file, double width,
                           double height);

/** The shared object of PNG and PDF canvases, which stands beside libgraze.so. */
#define PNG_LIBRARY "libgraze-png-" GRAZE_VERSION ".so"

/* Triangles and lines as pixels, for meshes so dense that their paths would be a large file. */

/** The pixels of a panel's frame. Zeroed by raster_init where memory is short. */
typedef struct raster {
    int width, height;
    unsigned *pixel; /* a paint, or 0 */
} raster;

/** Pixels of a frame, all empty; 0 without memory. */
int raster_init(raster *r, const panel *p);
void raster_clear(raster *r);
/** Paint the pixels whose centres a triangle holds, which is given in pixels from the frame's upper
 * left corner. */
void raster_triangle(raster *r, const double x[3], const double y[3], unsigned paint,
                     double faintness);
void raster_line(raster *r, const double from[2], const double to[2], unsigned paint,
                 double faintness);
/** Draw the pixels as runs of one colour; shades are merged until the runs are few. */
void raster_draw(canvas *c, const raster *r, const panel *p);

/* The solid at one time, as lines and faces of a picture.
 *
 * Its vertices are doubles: a picture of the solid decides nothing. */

/** The solid (borrowed) at one time: the images of its vertices, three coordinates each. */
typedef struct shape {
    const graze_solid *solid;
    double *at;
    int reflected; /* the map turns the boundary inside out */
} shape;

/** The solid where it stands. Cleared by shape_clear, also on failure. */
graze_status shape_standing(shape *out, graze_context *context, const graze_solid *solid);
/** The solid at a time of the motion, t0 <= t <= t1, or under the inverse of the map of that time.
 */
graze_status shape_moved(shape *out, graze_context *context, const graze_solid *solid,
                         const graze_motion *motion, const fmpq_t t, int inverse);
void shape_clear(shape *s);

/** The extent of the shape's image. */
void shape_extent(extent *out, const shape *s, const projection *look);

/** Add the boundary in E^2 (normal NULL), ring by ring; in E^3 the lines in which it meets the
 * plane normal . x = place. */
void shape_outline(drawn_path *out, const shape *s, const panel *p, const double *normal,
                   double place);

/** Paint the faces of shapes in E^3 that are turned towards the onlooker, the far ones first. */
graze_status shapes_paint(canvas *c, graze_context *context, const shape *shapes,
                          const finish *finishes, size_t count, const panel *p);

/** A new canvas of a size in pixels; GRAZE_ESYSTEM without memory. */
graze_status canvas_create_svg(canvas **out, graze_context *context, double width, double height);

/* The panels of a picture. */

/** All that a picture shows, made before the canvas is, whose size follows from it. */
typedef struct picture {
    const graze_scene *scene;
    const draw_request *request;
    cells cells;
    section section;  /* where the request has a normal */
    graze_solid made; /* for the eye, of a curved solid */
    size_t undecided; /* cells */
    shape *moved;     /* at request->times times; for an unsweep under the inverse motion */
    shape standing;
    trail *trails;  /* one a point */
    double *points; /* three coordinates each */
    legend legend;
    panel classes, positions, trajectories;
    int has_positions, has_trajectories, failed; /* without memory */
} picture;

/** Choose the windows and sizes of the panels, not yet their places.
 * @return GRAZE_ELIMIT a window beyond what doubles can draw (range_check) */
graze_status views_fit(picture *p, graze_context *context);
/** Note in the legend what the panels show; after views_fit. */
void views_seen(picture *p);
/** 1 in E^2. */
int picture_is_plane(const picture *p);
/** How many points lie outside the panel that shows points where they are; after views_fit. */
size_t views_outside(const picture *p);
/** The classes of the cells, with the positions of S and the points in their plane. */
graze_status view_classes(canvas *c, graze_context *context, const picture *p);
/** The positions of S in space, seen from the onlooker. */
graze_status view_positions(canvas *c, graze_context *context, const picture *p);

/* The panel of trajectories. */

/** Draw the trajectories through the standing S. */
graze_status view_trajectories(canvas *c, graze_context *context, const picture *p);
/** Note in the legend what the panel of trajectories shows; after views_fit. */
void trajectories_seen(picture *p);

#endif
