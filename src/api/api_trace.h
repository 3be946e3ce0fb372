/* Rows of points that were traced, for the public functions of other files.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_API_TRACE_H
#define GRAZE_API_TRACE_H

#include "api/api.h"
#include "base/number/text.h"
#include "decide/trace/trace.h"
#include "graze/certify.h"

/** GRAZE_EUSE: there is no such form of a row, or not of this scene. */
graze_status api_check_format(graze_context *context, const char *function,
                              const graze_scene *scene, graze_format format);

/** What rows say together; counted on. */
typedef struct row_totals {
    unsigned long undecided; /* positions relative to the closed sweep */
    unsigned long wide;      /* enclosures wider than was asked for */
} row_totals;

/** Add the row of a point that was traced; for JSON Lines with its contacts. */
graze_status api_trace_row(text *out, row_totals *totals, graze_context *context,
                           const graze_scene *scene, const fmpq *point, const graze_trace *trace,
                           graze_format format, const char *rest);

/** graze_report_points and graze_certificate_points, with what their rows say together. */
graze_status api_report_points(char **out, size_t *length, size_t *done, row_totals *totals,
                               graze_context *context, const graze_scene *scene,
                               graze_rationals points, size_t n, graze_format format,
                               const char *const *rest);
graze_status api_certificate_points(char **out, size_t *length, char **table, size_t *table_length,
                                    size_t *done, row_totals *totals, graze_context *context,
                                    const graze_certifier *certifier, graze_rationals points,
                                    size_t n, graze_format format, const char *const *rest);

#endif
