/* Members that are singular at the point, alone or in company: cones of one apex.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_APEX_H
#define GRAZE_CURVED_APEX_H

#include "decide/curved/sign_germ.h"

/** Ask directions, one in each open cell that the lowest forms of the members cut out: they show
 * patterns, and of the members that are homogeneous at the point these are all (proofs/curved.md
 * C99, C129). */
void apex_ask(sign_germ *g);

#endif
