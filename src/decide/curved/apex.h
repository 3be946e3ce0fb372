/* Patterns near a point at which some members are singular: the members are like cones with this
 * apex. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_APEX_H
#define GRAZE_CURVED_APEX_H

#include "decide/curved/sign_germ.h"

/** Ask one direction in each open cell of the members' lowest forms. The patterns found there
 * occur; if all members are homogeneous at the point, no others do (proofs/curved.md C99, C129). */
void apex_ask(sign_germ *g);

#endif
