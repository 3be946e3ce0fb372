/* Explains a position relative to the closed sweep to a person.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_CLOSED_H
#define GRAZE_REPORT_CLOSED_H

#include "base/number/text.h"
#include "questions/topo/finding.h"

/** Append the position of a point, the level that decided it, and its witness or the reason why it
 * is undecided. */
void closed_explain(text *t, const topo_finding *topo, int dimension);

/** Append whether a point is in the closure of an unsweep's interior, in the same form. */
void closed_explain_regular(text *t, const topo_finding *regular, int dimension);

#endif
