/* page: a page of HTML that shows a scene, to be turned and asked.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_OUTPUT_PAGE_H
#define GRAZE_OUTPUT_PAGE_H

#include <stdint.h>
#include "base/number/text.h"
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

/* Values of a page's data: strings of JSON, and arrays of numbers as base64. */

/** A string of JSON that may stand within a script of HTML. Bytes that are no character become
 * question marks. */
void encode_string(text *out, const char *string);
/** A double as JSON, with 17 digits; null unless it is finite. */
void encode_number(text *out, double value);

/** An array of little-endian numbers as a string of base64. Zeroed but for `out` to begin with. */
typedef struct encoder {
    text *out;
    unsigned char rest[3];
    int held;
} encoder;

/** Begin an array behind a text. */
void encode_begin(encoder *e, text *out, const char *before);
void encode_byte(encoder *e, unsigned char byte);
void encode_double(encoder *e, double value);
void encode_float(encoder *e, float value);
void encode_count(encoder *e, uint32_t value);
void encode_end(encoder *e);

/* A page of HTML that shows a scene, to be turned and asked.
 *
 * The page holds all it needs: program, data, and three.js, which draws. It asks for nothing from
 * a network, and what it says of a point was decided here. */

/** Write the page of a request. @return what graze_draw does */
graze_status page_write(graze_context *context, const graze_scene *scene, const char *file,
                        const draw_request *request);

/* The cells of a page: the plane, or a plane of space, coloured by class. */

/** The cells of a request as an object of JSON (src/output/page/README.md), by class in any case.
 */
graze_status page_cells(text *out, graze_context *context, const graze_scene *scene,
                        const draw_request *request);

/* The points of a page: answers and contacts, from which the page makes its sentences. */

/** All points of a request as an object of JSON (src/output/page/README.md).
 * @param centre  the centre of the page's box; places are written relative to it
 */
graze_status page_rows(text *out, graze_context *context, const graze_scene *scene,
                       const draw_request *request, const double *centre);

/* The solid, the motion and the sweep's surface of a page. */

/** The solid as an object of JSON: vertices, triangles (E^2: none), edges. */
graze_status page_solid(text *out, graze_context *context, const graze_solid *solid);
/** The motion's pieces as an array of JSON: coefficients as doubles, which only draw. */
void page_motion(text *out, const graze_motion *motion, graze_operation operation);
/** The mesh of a request as an object of JSON; null if it has none.
 * @param centre  the centre of the page's box; places are written relative to it */
void page_mesh(text *out, const draw_request *request, const double *centre);
/** The surface of the sweep as an object of JSON; null if the request wants none.
 * @param centre  the centre of the page's box; places are written relative to it */
graze_status page_surface(text *out, graze_context *context, const graze_scene *scene,
                          const draw_request *request, const double *centre);

#endif
