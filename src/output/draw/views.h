/* The views of a picture: its lines, shapes, labels, marks and legend, and the kinds of canvas.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_OUTPUT_DRAW_VIEWS_H
#define GRAZE_OUTPUT_DRAW_VIEWS_H

#include "output/draw/panel.h"
#include "questions/outline/outline.h"

/* Paths, and drawing on a canvas (draw.h). */

void drawn_path_clear(drawn_path *p);
void drawn_path_to(drawn_path *p, char verb, double x, double y);
/** Add a segment, and a rectangle by two of its corners. */
void drawn_path_line(drawn_path *p, double x0, double y0, double x1, double y1);
void drawn_path_box(drawn_path *p, double x0, double y0, double x1, double y1);

/** Write the file, unless `status` is a failure of drawing, which is returned; free the canvas. */
graze_status canvas_finish(canvas *c, graze_context *context, const char *file,
                           graze_status status);

/** Begin a part of the picture with a name and perhaps attributes, `key="value"` as in SVG. */
void canvas_begin(canvas *c, const char *name, const char *attributes);
void canvas_end(canvas *c);
/** Draw a path with the even-odd rule, and clear it. `name` is the class of the SVG element, or
 * NULL. */
void canvas_path(canvas *c, drawn_path *p, const style *s, const char *name);
/** Draw a line of UTF-8 on its baseline. Control characters and bytes that are not UTF-8 become
 * question marks. */
void canvas_text(canvas *c, double x, double y, const lettering *l, const char *string);
/** Width of a text in pixels, for fonts as wide as DejaVu Sans. */
double canvas_text_width(const char *string, double size);

/* Contours between points of a grid, found by bisection of exact classifications. */

/** A contour's nodes are exact to this part of a pixel. */
enum { CONTOUR_FINENESS = 32 };

/**
 * Add the region of the points of the set (in or on) whose tone is `least` or a later one, as
 * closed polygons, by marching squares between the cells' centres. A node is the middle of an
 * interval on a square's side, at most 1 / CONTOUR_FINENESS of a pixel long, with one end in the
 * region. The centre of a square of four nodes is classified to tell which nodes are joined.
 * Undecided points are outside. Beyond the outermost centres lines go straight on to the frame.
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

/** The obstacles of one panel, each in every bin that it meets. Obstacles outside the panel are
 * left out, since names stand inside. `failed` is set once memory has run short. */
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
/** Keep names off a disk, such as a marker. */
void labels_avoid(labels *l, double x, double y, double radius);
/** 1 if the square of side 2 radius about a pixel meets a disk of labels_avoid. */
int labels_meet_mark(const labels *l, double x, double y, double radius);
/** Keep names off a line through pixels. */
void labels_avoid_path(labels *l, const drawn_path *p);
/** A place to be named. */
typedef struct labelled_point {
    double x, y;  /* a pixel of the panel */
    double sign;  /* radius of the sign at this pixel; 0: none */
    double reach; /* greatest distance of the name */
} labelled_point;
enum { REACH_NEAR = 24, REACH_FAR = 124 };

/** Write a name in free space beside a place, with a thin line to the place if the name is not next
 * to it. The name is an obstacle from then on. Returns 0 if there is no free space. */
int labels_place(labels *l, canvas *c, labelled_point at, const char *name);
/** Write the number of names that were left out, unless it is 0, over the panel's right corner. */
void labels_tell(const labels *l, canvas *c);

/* The signed distances of cells: their bands of colour, level lines and the border of the set.
 * The sign of the distance at a cell's centre is exact, its value within 1/64 of the cell's side.
 */
/** Append the distances of a band, such as `-2 to -1`. */
void band_put(text *out, const cells *c, tone t);

/* The colours and signs of a picture, and the legend that explains those that were used.
 * The colours are from Okabe and Ito's palette (Color Universal Design, 2008), made so that the
 * colour-blind can tell its colours apart; areas that meet often differ in lightness too. */
/** The colour 0xRRGGBB of thing k among several, from this palette without the colour of `on`; the
 * colours repeat. */
unsigned mark_colour(size_t k);

/** Draw a query point as a disk in its colour. A disk of MARK_LARGE remains visible under a
 * contact.
 */
void mark_point(canvas *c, double x, double y, double radius, tone t);
enum { MARK_RADIUS = 5, MARK_LARGE = 8 };
/** Draw a contact: full for an intersection, hollow for a tangency, small and in the colour of
 * sliding for the end of a slide (kind 0); a circle on a face, a square on an edge, a triangle on a
 * vertex. */
void mark_contact(canvas *c, double x, double y, graze_kind kind, graze_cell_kind cell);
/** Outlines of S at the start, at the end and between. */
extern const style outline_start, outline_end, outline_between;
/** Level lines of the distance, and the border between cells of different answers. */
extern const style line_level, line_border;
/** Arcs of the outline, by curve_source. */
extern const style arc_style[3];
/** The rectangle of the cells, seen in space. */
extern const style outline_plane;
/** A trajectory outside, inside and on the boundary of S. */
extern const style trail_outside, trail_inside, trail_sliding;

/** Things that a picture shows, for its legend; all members but `cells` are flags. */
typedef struct legend {
    int tones[TONE_COUNT];
    const cells *cells; /* coloured by distance; NULL: by class */
    int positions[4];   /* outlines of S at the start, between, at the end; the cells' plane */
    int sources[3];     /* arcs of the outline, by curve_source */
    int spans[3];       /* parts of trajectories outside S, inside, sliding on its boundary */
    int contacts[3][4]; /* by kind and cell; kind 0 is the end of a slide */
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
/** Create a canvas of the kind of the file's extension, after canvas_check. */
graze_status canvas_create(canvas **out, graze_context *context, const char *file, double width,
                           double height);

/** The shared object of PNG and PDF canvases, which stands beside libgraze.so. */
#define PNG_LIBRARY "libgraze-png-" GRAZE_VERSION ".so"

/* Triangles and lines as pixels, for meshes so dense that their paths would be a large file. */

/** The pixels of a panel's frame; raster_init zeroes the struct when out of memory. */
typedef struct raster {
    int width, height;
    unsigned *pixel; /* a paint, or 0 */
} raster;

/** Make the pixels of a frame, all empty; 0 when out of memory. */
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
 * Its vertices are doubles, which only pictures use. */

/** The solid (borrowed) at one time: the images of its vertices, three coordinates each. */
typedef struct shape {
    const graze_solid *solid;
    double *at;
    int reflected; /* the map turns the boundary inside out */
} shape;

/** Make the shape of the solid where it stands. shape_clear frees it, also on failure. */
graze_status shape_standing(shape *out, graze_context *context, const graze_solid *solid);
/** Make the shape of the solid at a time of the motion, t0 <= t <= t1; if `inverse`, under the
 * inverse of the map at that time. */
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

/** Create an SVG canvas of a size in pixels; GRAZE_ESYSTEM when out of memory. */
graze_status canvas_create_svg(canvas **out, graze_context *context, double width, double height);

/* The panels of a picture. */

/** All contents of a picture. They are made before the canvas, whose size depends on them. */
typedef struct picture {
    const graze_scene *scene;
    const draw_request *request;
    cells cells;
    section section;  /* the plane of a request with a normal */
    graze_solid made; /* stands for a curved solid (eye_solid_make) */
    size_t undecided; /* number of undecided cells */
    shape *moved;     /* at request->times times; for an unsweep under the inverse motion */
    shape standing;
    trail *trails;  /* one for each point */
    double *points; /* three coordinates each */
    legend legend;
    panel classes, positions, trajectories;
    graze_outline outline; /* of a polygon by class, if has_arcs */
    outline_polygon arcs;
    int has_arcs, has_positions, has_trajectories, failed; /* failed: without memory */
} picture;

/** Choose the windows and sizes of the panels, not yet their places.
 * @return GRAZE_ELIMIT a window beyond what doubles can draw (range_check) */
graze_status views_fit(picture *p, graze_context *context);
/** Note in the legend what the panels show; after views_fit. */
void views_seen(picture *p);
/** 1 in E^2. */
int picture_is_plane(const picture *p);
/** Number of points outside the panel that shows points at their places; after views_fit. */
size_t views_outside(const picture *p);
/** Draw the panel of the cells' classes, with positions of S and the points in the cells' plane. */
graze_status view_classes(canvas *c, graze_context *context, const picture *p);
/** Draw the panel of the positions of S in space, as the viewer sees them. */
graze_status view_positions(canvas *c, graze_context *context, const picture *p);

/** Make the arcs of a polygon's outline, after views_fit; none where the outline is beyond a
 * limit. The caller calls arcs_clear in any case. */
graze_status arcs_make(picture *p, graze_context *context);
void arcs_clear(picture *p);
/** Draw the arcs into the panel of the classes. */
void arcs_draw(canvas *c, const picture *p);

/* The panel of trajectories. */

/** Draw the trajectories through the standing S. */
graze_status view_trajectories(canvas *c, graze_context *context, const picture *p);
/** Note in the legend what the panel of trajectories shows; after views_fit. */
void trajectories_seen(picture *p);

#endif
