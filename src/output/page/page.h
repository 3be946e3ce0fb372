/* page: a page of HTML that shows a scene. Its reader can turn the scene and read what Graze has
 * decided about the given points.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_OUTPUT_PAGE_H
#define GRAZE_OUTPUT_PAGE_H

#include <stdint.h>
#include "base/number/json.h"
#include "decide/scene/scene.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "output/draw/draw.h"
#include "output/report/report.h"

/* The files of a page, which the library holds. */

/** Texts, each ended by a NUL: page.html, three.js, and its licence. */
extern const char asset_template[] ASSET, asset_three[] ASSET, asset_licence[] ASSET;
/** The page's own scripts in their order, ended by NULL. */
extern const char *const asset_program[];

/* Values of a page's data that base/number/json.h lacks: strings within a script, and arrays of
 * numbers as base64. */

/** Write a string of JSON such that it may stand within a script of HTML. Bytes that are not UTF-8
 * become question marks. */
void encode_string(json_writer *w, const char *key, const char *string);

/** An array of little-endian numbers as a string of base64. At first all but `out` is zeroed. */
typedef struct encoder {
    text *out;
    unsigned char rest[3];
    int held;
} encoder;

void encode_begin(encoder *e, json_writer *w, const char *key);
void encode_byte(encoder *e, unsigned char byte);
void encode_double(encoder *e, double value);
void encode_float(encoder *e, double value);
/** Add a point of d coordinates as 32-bit floats, relative to the centre of the page's box. */
void encode_place(encoder *e, const fmpq *place, const double *centre, int d);
void encode_count(encoder *e, uint32_t value);
void encode_end(encoder *e);

/* A page of HTML that shows a scene.
 *
 * The page holds all it needs: program, data, and three.js, which draws. It needs no network, and
 * the answers that it shows for points were decided by Graze. */
/** Write the page of a request. @return as graze_draw */
graze_status page_write(graze_context *context, const graze_scene *scene, const char *file,
                        const draw_request *request);

/* The parts of a page's data, each a member of one JSON object (src/output/page/README.md). Places
 * are written relative to `centre`, the centre of the page's box. */
/** `cells`: the cells of the plane, or of a plane of space, always coloured by class. */
graze_status page_cells(json_writer *w, graze_context *context, const graze_scene *scene,
                        const draw_request *request);

/** `points`: answers and contacts, from which the page makes its sentences. */
graze_status page_rows(json_writer *w, graze_context *context, const graze_scene *scene,
                       const draw_request *request, const double *centre);

/** `solid`: vertices, triangles (E^2: none), edges. */
graze_status page_solid(json_writer *w, graze_context *context, const graze_solid *solid);
/** `motion`: its pieces, with coefficients as doubles, by which the page only draws. */
void page_motion(json_writer *w, const graze_motion *motion, graze_operation operation);
/** `mesh`: the mesh of the request; null if the request has none. */
void page_mesh(json_writer *w, const draw_request *request, const double *centre);
/** `surface`: the surface of the sweep; null if the request wants none. */
graze_status page_surface(json_writer *w, graze_context *context, const graze_scene *scene,
                          const draw_request *request, const double *centre);

#endif
