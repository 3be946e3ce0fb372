/* The filter checked against the exact path: between a certain crossing and an exact window next to
 * it in time, the state beside the crossing is compared with an exact location. word_read compares
 * two crossings that are neighbours.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TRACE_CROSSCHECK_H
#define GRAZE_TRACE_CROSSCHECK_H

#include "decide/trace/tracer.h"

/** Check a certain crossing in `piece`, which is later than all findings before it. @return
 * GRAZE_EINTERNAL if the state before it differs from the state found after the last exact window
 */
graze_status crosscheck_crossing(tracer *r, size_t piece, int enters);

/** An exact window [from, to], in 2^-WINDOW_LEVELS of `piece`, whose ends within the piece are off
 * the boundary; likewise. */
graze_status crosscheck_window(tracer *r, size_t piece, uint32_t from, uint32_t to);

#endif
