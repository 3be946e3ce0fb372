/* First terms of polynomials along a curve that some surfaces may share.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_CURVE_FIELD_H
#define GRAZE_CURVED_CURVE_FIELD_H

#include "decide/curved/series.h"
#include "decide/curved/sign_germ.h"

/** Find the first term as probe_first does. Before high orders are computed, a common curve of all
 * members of a set is sought: one through the point along which the rank of their gradients is
 * constant (proofs/flows.md C121). */
int flow_first(int *order, sign_germ *g, probe *p, unsigned members, const taylor *of, int most);

#endif
