/* The position relative to the closed sweep, for a person.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_CLOSED_H
#define GRAZE_REPORT_CLOSED_H

#include "base/number/text.h"
#include "questions/topo/finding.h"

/** Append the position of a point, what decided it, and its witness or why it is undecided. */
void closed_explain(text *t, const topo_finding *topo, int dimension);

/** The same of whether a point is in the closure of an unsweep's interior. */
void closed_explain_regular(text *t, const topo_finding *regular, int dimension);

#endif
