/* A point of a facet that lies in no lower cell. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_ENVELOPE_WITHIN_H
#define GRAZE_ENVELOPE_WITHIN_H

#include "questions/envelope/cells.h"

/** The middle of the facet's first simplex, or, if a vertex or an edge of another facet lies
 * there, a point beside it. @param[out] out d rationals */
graze_status within_facet(fmpq *out, graze_context *context, const cell_complex *cells,
                          size_t facet);

#endif
