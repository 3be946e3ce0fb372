/* The contacts of a trace, built from the touches of one piece after another.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TRACE_CONTACT_H
#define GRAZE_TRACE_CONTACT_H

#include "decide/trace/touch.h"
#include "decide/trace/trace.h"

/**
 * Append the contacts of a piece, whose touches are ordered. A contact that lasts to the end of the
 * last piece goes on if this piece begins with a contact, since the trajectory is continuous.
 * @param opens 1: the touches include all at the beginning of the piece; 0: they are later ones
 */
graze_status contacts_append(graze_trace *trace, graze_context *context, const graze_motion *motion,
                             size_t piece, const touches *t, int opens);

/** Append a certain crossing within a piece, which has no times and no cells. */
graze_status contacts_append_crossing(graze_trace *trace, graze_context *context, int enters);

/** Replace the simplices' cells in all contacts by the names that the input has for them. */
graze_status contacts_name(graze_trace *trace, graze_context *context, const cell_names *names);

#endif
