/* Rows, for the public functions of other files.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_API_ROWS_H
#define GRAZE_API_ROWS_H

#include "api/api.h"
#include "base/number/text.h"
#include "output/report/table_row.h"

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

#endif
