/* The states between the contacts of a trace, and its word.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TRACE_WORD_H
#define GRAZE_TRACE_WORD_H

#include "decide/trace/tracer.h"

/**
 * Fill the states beside the contacts of `r->out`, those at both ends, and the word. A certain
 * crossing knows the states beside it; a gap between two contacts that do not is located.
 * @return GRAZE_EINTERNAL if two crossings disagree on the gap between them
 */
graze_status word_read(tracer *r);

#endif
