/* draw: pictures of a scene, as SVG or on a canvas.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_OUTPUT_DRAW_H
#define GRAZE_OUTPUT_DRAW_H

#include <flint/fmpq.h>
#include <stddef.h>
#include <stdint.h>
#include "base/number/text.h"
#include "decide/scene/scene.h"
#include "input/csg/csg.h"
#include "input/solid/solid.h"
#include "input/validate/validate.h"
#include "questions/topo/topo.h"

/* A surface to draw on, in pixels from the upper left corner; made of paths, circles and texts.
 *
 * There are an SVG text, a PNG image and a page of PDF. Drawing never fails half-way: a failure is
 * kept and returned by canvas_finish. */

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

/** Bytes of the UTF-8 character at `at`, or 0 if there is none that XML takes. */
size_t canvas_character(const char *at);

/* Functions of a kind of canvas; those of groups may be NULL. */

/** Takes bytes; 0 without memory. */
typedef int canvas_put(void *to, const char *bytes, size_t length);

typedef struct canvas_kind {
    void (*begin)(canvas *c, const char *name, const char *attributes);
    void (*end)(canvas *c);
    /* Draw only inside a rectangle until unclip. */
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

/** Two rows that take a point to the coordinates of the picture's plane. In E^2 the third
 * coordinate of every point is 0. */
typedef struct projection {
    double row[2][3];
} projection;

/** The least rectangle of the plane around the points that were added; empty at first. */
typedef struct extent {
    double low[2], high[2];
} extent;

/** Can doubles hold a box of `count` coordinates, and differences in it to less than a pixel?
 * @return GRAZE_ELIMIT if not */
graze_status range_check(graze_context *context, const double *low, const double *high, int count);

typedef struct section {
    fmpq *normal, *place; /* normal . x = place; one vector holds all of this and the next line */
    fmpq *origin, *way[2];
    projection look;             /* to u and v */
    double unit[3], unit_height; /* normal and place, the normal of length 1 */
} section;
void section_clear(section *s);

/** Colour of a point: by its class for a sweep, by its pmc for an unsweep; that of a cell may also
 * be a band of its distance. */
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

/** The distance of two marks on a scale: mantissa 1, 2 or 5 times 10^exponent. */
typedef struct tick_step {
    int mantissa, exponent;
    double size;
} tick_step;

/** Cell (i, j) has its centre at low + (i + 1/2, j + 1/2) side. */
typedef struct cells {
    int axis[2]; /* the coordinates along which i and j run */
    size_t count[2];
    fmpq *low;              /* a corner of d coordinates; off the two axes, the plane's place */
    int dimension;          /* 2 with a section, whose u and v they are */
    const section *section; /* borrowed; NULL: the plane of two axes */
    fmpq_t side;
    unsigned char *tone; /* row by row, i running fastest */
    size_t parts;    /* number of parts of a split cell along each side, odd; 1: none is split */
    uint32_t *split; /* by cell: 0, or the number, from 1, of its block of parts */
    size_t split_count;
    unsigned char *part; /* tones of the parts, block by block, row by row */
    double *distance;    /* of the cells' centres; NULL: not asked */
    tick_step step;      /* distance between levels */
} cells;
void cells_clear(cells *c);

/** The plane of the cells in E^3, on `axis` or a section's: `z = 3`, `z = 7/2 = 3.5`, a long ratio
 * as a decimal alone. */
void cells_plane(text *out, const cells *c, int axis);
/** The rectangle of the plane that the cells cover. */
extent cells_extent(const cells *c);
/** The point of E^3 with two given coordinates in the plane of the cells. */
void cells_corner(double out[3], const cells *c, double horizontal, double vertical);

/* Cells at borders, split into parts, so that a border has no stairs.
 *
 * A cell is split where one of its eight neighbours has another tone; each part is classified
 * exactly at its own centre. The middle part has the cell's centre. */

/**
 * Split the cells at borders; of measured cells, those at borders between answers. A cell is split
 * into at most 7 parts, none smaller than 1/2600 of the grid's longer side.
 * @return GRAZE_ELIMIT more parts than the limit `grid`
 */
graze_status parts_classify(cells *c, graze_context *context, const graze_scene *scene);

/* The picture of what contacts cover of the directions about an `on` point of E^2. */

/** Draw what contacts cover of the directions about the point, and write the picture to a file.
 * @return what graze_draw_cones does */
graze_status draw_cones(graze_context *context, const graze_scene *scene, const char *file,
                        const fmpq *point, const topo_finding *topo);

/* The request for a picture. */

/** A mesh in the colours of distances. All is borrowed. */
typedef struct draw_mesh {
    const fmpq *vertices; /* three each */
    size_t vertex_count;
    const uint32_t *corners; /* three vertices each */
    size_t triangle_count;
    const double *distance; /* one a vertex, negative inside the sweep */
} draw_mesh;

/** Contents of a picture: the numbers of graze_draw_options, checked and with their defaults.
 */
typedef struct draw_request {
    const char *title;
    unsigned long grid;     /* 0: two pixels a cell */
    unsigned long times;    /* at least 2 */
    int by_distance;        /* colours of cells: bands of the signed distance, else classes */
    const fmpq *low, *high; /* d each, low < high; both NULL: around the scene */
    int plane_axis;         /* E^3 */
    const fmpq *plane;      /* NULL: the middle of the box */
    const fmpq *normal;     /* three: the plane is normal . x = *plane; NULL: an axis' plane */
    double view[3];         /* not zero */
    const fmpq *points;     /* d each */
    size_t point_count;
    const char *const *names; /* one a point */
    /* Pages alone: */
    const char *const *strata;  /* one a point, or NULL; entries may be NULL */
    const char *const *answers; /* the same: a candidate's, where it is wrong */
    unsigned surface;           /* level of the sweep's surface; 0: none */
    const draw_mesh *mesh;      /* shown in place of the surface; NULL: none */
} draw_request;

/* The picture of a scene: classes on a grid of cells, positions of the solid, trajectories. */

/** Make a picture and write it to a file. @return what graze_draw does */
graze_status draw_picture(graze_context *context, const graze_scene *scene, const char *file,
                          const draw_request *request);

/* The boundary of a curved solid, as segments or triangles made for the eye.
 *
 * Made in doubles: a picture of the solid decides nothing. */

/** Make a solid that stands for a curved one in pictures and nowhere else: only its vertices'
 * bounds and its simplices are set, segments in the plane, triangles in space. Details narrower
 * than a cell of the lattice, a 256th of the box in the plane and a 64th in space, may be missed.
 * Cleared by eye_solid_clear, also on failure.
 * @param solid with a box
 */
graze_status eye_solid_make(graze_solid *out, graze_context *context, const csg *solid);
void eye_solid_clear(graze_solid *made);

/** The colour 0xRRGGBB of a tone and its name in the tables. */
unsigned tone_colour(tone t);
const char *tone_name(tone t);

/** 1 if a name has an extension, which is given in small letters without its dot. */
int file_has_extension(const char *file, const char *extension);

/* PNG and PDF canvases, made by a shared object of the same version that is loaded at need. */

/** Its function: a new canvas of a size in pixels, or NULL without memory. */
canvas *graze_png_create(double width, double height, int pdf);

/* The cells of a request. */

/**
 * Lay out and classify the cells of a request, and measure them where it is by distance.
 * @param[out] out      cleared by cells_clear, also on failure
 * @param[out] oblique  the plane of a request with a normal; section_clear in any case, and not
 *                      before `out`. Zeroed before.
 * @return GRAZE_ELIMIT more cells than the limit `grid`; GRAZE_EUSE the plane misses the box
 */
graze_status request_cells(cells *out, section *oblique, graze_context *context,
                           const graze_scene *scene, const draw_request *request);

/* Shapes of space as the onlooker sees them. */

/** Paint of the faces of a shape. */
typedef struct finish {
    unsigned colour; /* 0xRRGGBB, in full light */
    double faintness;
    int edges; /* draw the boundary's edges, of a dense mesh the sharp ones */
} finish;

/* The edges of a solid that a picture shows: those at which it bends, of a dense mesh by more than
 * 30 degrees. Coplanar triangles are one face. */

/** An edge between two vertices of the input; side `side` of a simplex. */
typedef struct shown_edge {
    uint32_t from, to, simplex;
    unsigned char side, diagonal;
} shown_edge;

typedef struct edge_list {
    shown_edge *item; /* malloc'ed; each edge once */
    size_t count;
    unsigned char *sides; /* a byte for each simplex: bit k is set where side k is shown */
    uint32_t
        *face; /* by simplex: the least number of a simplex in its face of coplanar simplices */
} edge_list;

/** Choose the edges of a solid of E^3. Cleared by edge_list_clear, also on failure. */
graze_status edges_make(edge_list *out, graze_context *context, const graze_solid *solid);
void edge_list_clear(edge_list *e);

#endif
