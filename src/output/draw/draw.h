/* draw: pictures of a scene, as SVG or on a canvas.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_OUTPUT_DRAW_H
#define GRAZE_OUTPUT_DRAW_H

#include <stddef.h>
#include <stdint.h>
#include "base/number/text.h"
#include "decide/scene/scene.h"
#include "input/csg/csg.h"
#include "input/solid/solid.h"
#include "input/validate/validate.h"
#include "questions/topo/topo.h"

/* A surface to draw paths, circles and texts on, in pixels from the upper left corner.
 *
 * A canvas is an SVG text, a PNG image or a page of PDF. Drawing calls return no status: a failure
 * is kept and returned by canvas_finish. */

/** The paint of a colour 0xRRGGBB. The paint 0 paints nothing. */
#define PAINT(rgb) (0x1000000u | (rgb))

/** Style of a path or circle. Zeroed it draws nothing. */
typedef struct style {
    unsigned fill, stroke; /* paints */
    double width;          /* of the stroke */
    double dash;           /* length of dashes and gaps; 0: none */
    double faintness;      /* 0 opaque ... 1 invisible */
    int crisp;             /* 1: edges on whole pixels, without smoothing */
} style;

/** A step of a path: begin a part at a point, draw a line to a point, or close the part. */
typedef struct path_node {
    char verb; /* M, L or z */
    double x, y;
} path_node;

/** A path, which the drawn_path functions extend; `failed` is set once memory has run short. */
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

/* Functions of a kind of canvas; begin and end of groups may be NULL. */
/** Takes bytes; returns 0 when out of memory. */
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

/** A canvas; the struct of each kind of canvas begins with this one. */
struct canvas {
    const canvas_kind *kind;
    double width, height;
    int failed; /* memory ran short */
};

/** Dark ink, used for texts. */
#define INK 0x222222u

/** Write bytes into a file, or to standard output for a name that is `-` and an extension, such as
 * `-.svg`. @return GRAZE_ESYSTEM */
graze_status save_file(graze_context *context, const char *file, const text *bytes);

/** A linear map from a point to its coordinates in the picture's plane, one row each. In E^2 the
 * third coordinate of every point is 0. */
typedef struct projection {
    double row[2][3];
} projection;

/** The least rectangle of the plane around the points that were added; empty at first. */
typedef struct extent {
    double low[2], high[2];
} extent;

/** Check that doubles can hold a box of `count` coordinates, and differences in it to less than a
 * pixel.
 * @return GRAZE_ELIMIT if not */
graze_status range_check(graze_context *context, const double *low, const double *high, int count);

typedef struct section {
    fmpq *normal, *place;        /* the plane is normal . x = place */
    fmpq *origin, *way[2];       /* one vector holds all numbers of normal, place, origin and way */
    projection look;             /* takes a point to u and v */
    double unit[3], unit_height; /* the normal of length 1, and its product with the origin */
} section;
void section_clear(section *s);

/** Colour of a point by its class for a sweep, by its pmc for an unsweep; the colour of a cell may
 * also be a band of its distance. */
typedef enum tone {
    TONE_NONE = 0, /* no tone, or undecided */
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

/** A grid of square cells; cell (i, j) has its centre at low + (i + 1/2, j + 1/2) side. */
typedef struct cells {
    int axis[2]; /* the coordinates along which i and j run */
    size_t count[2];
    fmpq *low;              /* a corner; its coordinate off the two axes is the plane's place */
    int dimension;          /* number of coordinates of `low`; with a section 2, u and v */
    const section *section; /* borrowed; NULL: the plane of two axes */
    fmpq_t side;
    unsigned char *tone; /* row by row, i running fastest */
    size_t parts;    /* number of parts of a split cell along each side, odd; 1: none is split */
    uint32_t *split; /* by cell: 0, or the number, from 1, of its block of parts */
    size_t split_count;
    unsigned char *part; /* tones of the parts, block by block, row by row */
    double *distance;    /* distances of the cells' centres; NULL: not measured */
    tick_step step;      /* distance between levels */
} cells;
void cells_clear(cells *c);

/** Append the equation of the cells' plane in E^3, orthogonal to `axis` or a section's: `z = 3`,
 * `z = 7/2 = 3.5`, a long ratio only as a decimal. */
void cells_plane(text *out, const cells *c, int axis);
/** The rectangle of the plane that the cells cover. */
extent cells_extent(const cells *c);
/** The point of E^3 with two given coordinates in the plane of the cells. */
void cells_corner(double out[3], const cells *c, double horizontal, double vertical);

/* Cells at borders of tones are split into parts, so that a border shows no coarse steps.
 *
 * A cell is split where one of its eight neighbours has another tone; each part is classified
 * exactly at its own centre. The middle part has the cell's centre. */

/**
 * Split the cells at borders; of cells with distances, those at borders between answers. A cell is
 * split into at most 7 parts along each side, none smaller than 1/2600 of the grid's longer side.
 * @return GRAZE_ELIMIT more parts than the limit `grid`
 */
graze_status parts_classify(cells *c, graze_context *context, const graze_scene *scene);

/* The picture of the directions about an `on` point of E^2 that contacts cover. */
/** Draw the directions about the point that contacts cover, and write the picture to a file.
 * @return as graze_draw_cones */
graze_status draw_cones(graze_context *context, const graze_scene *scene, const char *file,
                        const fmpq *point, const topo_finding *topo);

/* The request for a picture. */

/** A mesh in the colours of distances. All is borrowed. */
typedef struct draw_mesh {
    const fmpq *vertices; /* three each */
    size_t vertex_count;
    const uint32_t *corners; /* three vertices each */
    size_t triangle_count;
    const double *distance; /* one for each vertex, negative inside the sweep */
} draw_mesh;

/** Contents of a picture: the numbers of graze_draw_options, checked and with their defaults.
 */
typedef struct draw_request {
    const char *title;
    unsigned long grid;     /* cells along the longer side; 0: cells of two pixels */
    unsigned long times;    /* at least 2 */
    int by_distance;        /* colours of cells: bands of the signed distance, else classes */
    const fmpq *low, *high; /* d each, low < high; both NULL: around the scene */
    int plane_axis;         /* E^3 */
    const fmpq *plane;      /* NULL: the middle of the box */
    const fmpq *normal;     /* three: the plane is normal . x = *plane; NULL: plane_axis */
    double view[3];         /* not zero */
    const fmpq *points;     /* d each */
    size_t point_count;
    const char *const *names; /* one for each point */
    /* The members from here on are for pages only. */
    const char *const *strata;  /* one for each point, or NULL; entries may be NULL */
    const char *const *answers; /* as strata: a candidate's answers where they are wrong */
    unsigned surface;           /* level of the sweep's surface; 0: none */
    const draw_mesh *mesh;      /* shown in place of the surface; NULL: none */
    const char *const *proof;   /* as in graze_draw_options */
} draw_request;

/* The picture of a scene: classes on a grid of cells, positions of the solid, trajectories. */

/** Make a picture and write it to a file. @return as graze_draw */
graze_status draw_picture(graze_context *context, const graze_scene *scene, const char *file,
                          const draw_request *request);

/* The boundary of a curved solid, as segments or triangles made for the eye.
 *
 * Made in doubles: a picture of the solid decides nothing. */

/** Make a solid that stands for a curved one in pictures and nowhere else: only the bounds of its
 * vertices and its simplices (segments in the plane, triangles in space) are set. Details narrower
 * than a cell of the lattice, a 256th of the box in the plane and a 64th in space, may be missed.
 * eye_solid_clear frees it, also on failure.
 * @param solid with a box
 */
graze_status eye_solid_make(graze_solid *out, graze_context *context, const csg *solid);
void eye_solid_clear(graze_solid *made);

/** The colour 0xRRGGBB of a tone and its name in the tables. */
unsigned tone_colour(tone t);
const char *tone_name(tone t);

/** 1 if a file name has an extension; `extension` is in lower case, without the dot. */
int file_has_extension(const char *file, const char *extension);

/* PNG and PDF canvases, made by a shared object of the same version that is loaded at need. */
/** Create a canvas of a size in pixels; NULL when out of memory. The shared object exports this. */
canvas *graze_png_create(double width, double height, int pdf);

/* The cells of a request. */

/**
 * Lay out and classify the cells of a request, and measure distances if the request is by distance.
 * @param[out] out      cleared by cells_clear, also on failure
 * @param[out] oblique  zeroed by the caller; the plane of a request with a normal. section_clear
 *                      clears it in any case, after `out`.
 * @return GRAZE_ELIMIT more cells than the limit `grid`; GRAZE_EUSE the plane misses the box
 */
graze_status request_cells(cells *out, section *oblique, graze_context *context,
                           const graze_scene *scene, const draw_request *request);

/* Shapes of space as the onlooker sees them. */

/** Paint of the faces of a shape. */
typedef struct finish {
    unsigned colour; /* 0xRRGGBB, in full light */
    double faintness;
    int edges; /* 1: draw the boundary's edges; of a dense mesh only sharp ones */
} finish;

/* The edges of a solid that a picture shows: edges at which the surface bends, in a dense mesh by
 * more than 30 degrees. Coplanar triangles are one face. */

/** An edge between two vertices of the input; side `side` of a simplex. */
typedef struct shown_edge {
    uint32_t from, to, simplex;
    unsigned char side, diagonal;
} shown_edge;

typedef struct edge_list {
    shown_edge *item; /* malloc'ed; each edge once */
    size_t count;
    unsigned char *sides; /* a byte for each simplex: bit k is set where side k is shown */
    uint32_t *face;       /* by simplex: the least number of a simplex in the same face */
} edge_list;

/** Choose the edges of a solid of E^3. Cleared by edge_list_clear, also on failure. */
graze_status edges_make(edge_list *out, graze_context *context, const graze_solid *solid);
void edge_list_clear(edge_list *e);

#endif
