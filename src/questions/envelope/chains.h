/* Connected parts of a curve.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_CHAINS_H
#define GRAZE_ENVELOPE_CHAINS_H

#include "questions/envelope/envelope_record.h"

/** Set chain and form of all parts (E^3). */
graze_status chains_find(graze_curve *c, graze_context *context, const cell_complex *cells);

#endif
