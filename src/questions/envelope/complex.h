/* Makes the cells of a boundary.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_COMPLEX_H
#define GRAZE_ENVELOPE_COMPLEX_H

#include "questions/envelope/cells.h"

/** @param[out] out uninitialised; complex_clear in any case */
graze_status complex_make(cell_complex *out, graze_context *context, const graze_solid *solid);
void complex_clear(cell_complex *c);

#endif
