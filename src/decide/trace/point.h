/* The trace of a point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TRACE_POINT_H
#define GRAZE_TRACE_POINT_H

#include "decide/trace/trace.h"

/**
 * Trace the curve t -> map(t) P through the solid, where map is the motion's inverse (sweep) or the
 * motion itself (unsweep). The verdict stays empty (decide/verdict/classify.h fills it).
 * @param[out] out uninitialised; cleared by trace_clear. Unless TRACE_CONTACTS is asked for, its
 * contacts may lack times and cells.
 */
graze_status trace_point(graze_trace *out, graze_context *context, const graze_scene *scene,
                         query_point point, trace_detail detail);

#endif
