/* Events of an envelope as rows of a table (src/program/cli/formats.md, Envelope).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_EVENT_ROWS_H
#define GRAZE_REPORT_EVENT_ROWS_H

#include "base/number/text.h"
#include "questions/envelope/patch.h"

/** Head of the table of events. @param notes may be NULL */
graze_status report_events_header(char **out, graze_context *context, const graze_scene *scene,
                                  const char *notes);
/** A row of the table of events, from a canonical time. */
void report_event(text *out, const graze_envelope *envelope, const found_event *event);

/** Head of the table of curves. @param notes may be NULL */
graze_status report_curve_header(char **out, graze_context *context, const graze_scene *scene,
                                 const char *notes);
void report_curve(text *out, const graze_curve *curve, const curve_part *part);

/** Heads of the tables of patches and joints. @param notes may be NULL */
graze_status report_patches_header(char **out, graze_context *context, const graze_scene *scene,
                                   const char *notes);
graze_status report_joints_header(char **out, graze_context *context, const graze_scene *scene,
                                  const char *notes);
/** Rows of these tables, from canonical times. */
void report_patch(text *out, const graze_patches *patches, size_t index);
void report_joint(text *out, const graze_patches *patches, size_t index);

#endif
