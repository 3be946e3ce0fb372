/* api: the functions of the public headers, of everything below.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_API_H
#define GRAZE_API_H

#include <flint/fmpq.h>
#include <stddef.h>
#include "base/context/context.h"
#include "base/number/text.h"
#include "decide/lattice/lattice.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "graze.h"
#include "graze/core.h"
#include "input/solid/solid.h"

/* Declarations shared by the files of the public functions. */

/** The message of a wrong call; GRAZE_EUSE also where there is no context to hold it. */
graze_status api_misuse(graze_context *context, const char *function, const char *reason);

/** GRAZE_EINPUT: a function, or an option, that takes polyhedra alone was given a curved solid. */
graze_status api_curved(graze_context *context, const char *function);
/** GRAZE_EINPUT: a function that needs a box of the solid was given a curved one without. */
graze_status api_unbounded(graze_context *context, const char *function);

/**
 * Check a caller's rational.
 * @return GRAZE_EUSE it is not in lowest terms with a positive denominator; GRAZE_ELIMIT it has
 * more digits than the limit allows
 */
graze_status api_rational_check(graze_context *context, const mpq_t value);

/** Check a caller's rational and take it over. */
graze_status api_rational(fmpq_t out, graze_context *context, const mpq_t value);

/** Check a caller's point and take it over, into d rationals; the place of a failure is recorded.
 */
graze_status api_point(fmpq *out, graze_context *context, const graze_scene *scene,
                       graze_rationals point);

/** Put item and coordinate before a message and record the place; `item` may be NULL. */
graze_status api_coordinate(graze_context *context, graze_status status, const char *item,
                            size_t index, size_t coordinate);

/**
 * Copy the caller's options, whose first member is their size in bytes; the other members become
 * zero, and all do for NULL.
 * @param known size of the struct in this version
 * @return GRAZE_EUSE a size too small, or members that this version does not know
 */
graze_status api_options(void *out, size_t known, graze_context *context, const char *function,
                         const void *options);

/** Hand a rational to the caller's initialised variable. */
void api_rational_out(mpq_t out, const fmpq_t value);

/* The enclosure of one point's distance, for public functions of more than one file. */

/** As graze_distances, of one point, whose number is not told. */
graze_status api_enclose(graze_enclosure *out, graze_context *context, const graze_scene *scene,
                         const fmpq *point, double tolerance);

/* Grids, for the public functions of other files. */

/** Answers that are computed when they are first asked for; under locks of their own. */
typedef struct grid_memory {
    bricks bricks;
    axis_texts texts;
} grid_memory;

struct graze_grid {
    lattice lattice;
    grid_memory *memory;
};

/* Rows, for the public functions of other files. */

/** Take the caller's options of rows over. GRAZE_EUSE: unknown, or not together. */
graze_status api_rows(graze_row_options *out, graze_context *context, const char *function,
                      const graze_row_options *options);

/** Add the row of a point that was traced as row_detail says. `totals` are counted on, unless they
 * are NULL; `texts` may be NULL. */
graze_status api_row(text *out, graze_row_totals *totals, graze_context *context,
                     const graze_scene *scene, const fmpq *point, const graze_trace *trace,
                     const graze_row_texts *texts, const graze_row_options *shown);

/** Hand over the first `length` bytes, those of whole rows; none: `*out` stays NULL. */
void api_whole_rows(char **out, size_t *out_length, text *t, size_t length);

/* Solids of OpenSCAD's `.csg` files. */

/** Read a file and take everything as it stands. `sha256` is that of a file read before, or
 * NULL. */
graze_status api_scad_solid(graze_solid **out, graze_context *context, const char *path,
                            const unsigned char *sha256);

#endif
