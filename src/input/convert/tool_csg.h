/* Tools as curved solids, `.csg.json`.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_TOOL_CSG_H
#define GRAZE_CONVERT_TOOL_CSG_H

#include "base/number/text.h"
#include "input/convert/tool.h"

/** Begin and end a file around one node, moved by `at` (NULL: not). */
void tool_csg_begin(text *out, const fmpq *at);
void tool_csg_end(text *out, const fmpq *at);

/** The node of a tool whose side has the normal `low`. */
void tool_csg_write(text *out, const tool *s);
/** The node of a box from the origin, of these sides. */
void tool_csg_write_box(text *out, const fmpq *size);

#endif
