/* Conditions for an envelope to decompose (proofs/events.md C81 to C83).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_DECOMPOSITION_H
#define GRAZE_ENVELOPE_DECOMPOSITION_H

#include "questions/envelope/envelope_record.h"

static const graze_cell NO_CELL = {0, 0, 0};

/** Does a finding of this reason count, which is not the first of its kind? */
int judge_wants(const graze_envelope *e, graze_decomposable_reason reason);

/** A finding at a point of a piece's parameter. @param facet, cell borrowed */
graze_status judge_find(graze_envelope *e, graze_context *context, graze_decomposable_reason reason,
                        const graze_cell *facet, const graze_cell *cell, size_t piece,
                        const algebraic *u);
/** A finding before point k of an axis. */
graze_status judge_find_before(graze_envelope *e, graze_context *context,
                               graze_decomposable_reason reason, const graze_cell *facet,
                               const graze_cell *cell, size_t piece, const axis *x, size_t k);

/** Is point k of an axis a time before and after which the motion is one function? */
int judge_is_inner(const graze_envelope *e, size_t piece, const axis *x, size_t k);
/** Is it the common end of two different pieces? */
int judge_is_break(const graze_envelope *e, size_t piece, const axis *x, size_t k);

/** Does g of a facet vanish on all of it, on all of the motion? */
int judge_is_still(const graze_envelope *e, size_t facet);

#endif
