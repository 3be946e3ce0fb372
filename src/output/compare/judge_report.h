/* Reports of a mesh that was judged. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_COMPARE_JUDGE_REPORT_H
#define GRAZE_COMPARE_JUDGE_REPORT_H

#include "base/number/text.h"
#include "output/compare/comparison.h"
#include "questions/judge/judge.h"

/** Bounds are decimals that are bounds too.
 * @param points what the mesh says of points, or NULL
 * @return GRAZE_ESYSTEM */
graze_status judge_report(text *out, graze_context *context, const graze_judgement *judgement,
                          const graze_comparison *points, graze_judgement_format format);

#endif
