/* Where the slice of a facet goes from a vertex.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_ENTER_H
#define GRAZE_ENVELOPE_ENTER_H

#include "questions/envelope/envelope_record.h"

/** Whether the slice, or the whole facet if g = 0 on it, goes on from a vertex with g = 0 into the
 * relative interior of the facet or of a flat edge of it, at point k of a piece's axis or before
 * it. */
graze_status enters_at(int *out, const graze_envelope *e, graze_context *context, size_t facet,
                       size_t vertex, size_t piece, const axis *x, size_t k);
int enters_before(const graze_envelope *e, size_t facet, size_t vertex, size_t piece, const axis *x,
                  size_t k);

#endif
