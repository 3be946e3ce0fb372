/* Reports of a mesh that was judged. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_REPORT_JUDGE_REPORT_H
#define GRAZE_REPORT_JUDGE_REPORT_H

#include "base/number/text.h"
#include "questions/judge/judge.h"

/** Bounds are decimals that are bounds too. */
void judge_report(text *out, const graze_judgement *judgement, graze_judgement_format format);

#endif
