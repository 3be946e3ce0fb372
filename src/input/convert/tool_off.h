/* Polyhedra of tools, and boxes, as OFF.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_TOOL_OFF_H
#define GRAZE_CONVERT_TOOL_OFF_H

#include "base/number/text.h"
#include "input/convert/tool_pair.h"

/** Write one of both as OFF, moved by `at` (NULL: not): `factor` times the corners. */
void tool_write(text *out, const profile *p, const tool_pair *pair, const fmpq_t factor,
                const fmpq *at);
/** A box from the origin, of these sides. */
void tool_write_box(text *out, const fmpq *size, const fmpq *at);

#endif
