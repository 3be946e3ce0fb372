/* Parity against the exact path: where a certain crossing and an exact window are neighbours in
 * time, the state that the crossing tells is compared with an exact location between them. Two
 * crossings that are neighbours are compared by word_read.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TRACE_CROSSCHECK_H
#define GRAZE_TRACE_CROSSCHECK_H

#include "trace/tracer.h"

/** A certain crossing in `piece`, later than all before it. @return GRAZE_EINTERNAL if the state
 * before it is not what is found beside the exact window before it */
graze_status crosscheck_crossing(tracer *r, size_t piece, int enters);

/** An exact window [from, to], in 2^-WINDOW_LEVELS of `piece`, whose ends within the piece are off
 * the boundary; likewise. */
graze_status crosscheck_window(tracer *r, size_t piece, uint32_t from, uint32_t to);

#endif
