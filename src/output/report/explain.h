/* The reasoning for one point, for a person.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_EXPLAIN_H
#define GRAZE_REPORT_EXPLAIN_H

#include "base/number/text.h"
#include "decide/trace/trace.h"
#include "questions/distance/distance.h"
#include "questions/topo/finding.h"

/** The whole reasoning, for a person. */
graze_status report_explain(char **out, graze_context *context, const graze_scene *scene,
                            const fmpq *point, const graze_trace *trace, const topo_finding *topo,
                            const distance *found);

#endif
