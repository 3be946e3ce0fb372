/* Velocities of a vertex that lead into the solid.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_INWARD_H
#define GRAZE_ENVELOPE_INWARD_H

#include "questions/envelope/envelope_record.h"

/**
 * Does w, the velocity of the trajectory through a vertex, or -w lead into the solid's interior?
 * @param sign of g of the vertex's facets at u, in their order; not all 0
 */
graze_status inward_decide(int *out, const graze_envelope *e, graze_context *context, size_t vertex,
                           size_t piece, algebraic *u, const signed char *sign);

#endif
