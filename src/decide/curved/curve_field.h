/* First terms along a curve that some surfaces may have in common.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_CURVE_FIELD_H
#define GRAZE_CURVED_CURVE_FIELD_H

#include "decide/curved/series.h"
#include "decide/curved/sign_germ.h"

/**
 * As probe_first, along a curve that lies in all members of a set if any curve through the point
 * does along which the rank of their gradients stays: such a curve is looked for before high
 * orders are (proofs/flows.md C121).
 */
int flow_first(int *order, sign_germ *g, probe *p, unsigned members, const taylor *of, int most);

#endif
