/* Two polyhedra about a tool, within a tolerance.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_TOOL_FIT_H
#define GRAZE_CONVERT_TOOL_FIT_H

#include "base/number/text.h"
#include "input/convert/tool_pair.h"

/** Make both within a tolerance, which is positive.
 * @param[out] out    for tool_pair_clear, on success alone
 * @param[out] square as tool_pair_holds
 * @return GRAZE_EUSE it is too fine; GRAZE_ELIMIT, GRAZE_ECANCELED */
graze_status tool_fit(tool_pair *out, fmpq_t square, graze_context *context, const tool *s,
                      const fmpq_t tolerance);

/** Report both polyhedra and their distance from the shape. */
void tool_report(text *out, const tool_pair *p, const fmpq_t square);

#endif
