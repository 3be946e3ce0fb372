/* What Graze writes for one scene and its points (src/cli/formats.md, Tables).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A whole report is handed over as a malloc'ed text, a row is added to one; nothing depends on the
 * locale or on the order of calls, so the same scene and point give the same bytes.
 */
#ifndef GRAZE_REPORT_REPORT_H
#define GRAZE_REPORT_REPORT_H

#include "graze/report.h"
#include "number/text.h"
#include "scene/scene.h"
#include "trace/trace.h"

/** The `#` lines and the column line. `notes`: further `# key value` lines, or NULL. */
graze_status report_header(char **out, graze_context *context, const graze_scene *scene,
                           const char *notes, const char *columns);

/** Add one row of the table. `rest`: further columns as they were, or NULL. */
void report_csv(text *out, const graze_scene *scene, const fmpq *point, const graze_trace *trace,
                const char *rest);

/** Add one line of JSON. */
void report_json(text *out, const graze_scene *scene, const fmpq *point, const graze_trace *trace);

/** The whole reasoning, for a person. */
graze_status report_explain(char **out, graze_context *context, const graze_scene *scene,
                            const fmpq *point, const graze_trace *trace);

/**
 * The trajectory's coordinate under a piece's map, as a rational function of the motion's parameter
 * in lowest terms, such as `(2*t^2 - 1)/(t^2 + 1)`. What is left out of a long one is said.
 */
void formula_coordinate(text *out, const motion_piece *piece, const point_map *map, int coordinate,
                        const fmpq *point);
/** An integer polynomial in t, highest power first; shortened like a coordinate. */
void formula_polynomial(text *out, const fmpz_poly_t polynomial);
/** A rational, its middle digits left out and their number said where there are many. */
void formula_rational(text *out, const fmpq_t value);

#endif
