/* Members that are singular at the point: quadratic cones, alone or in company.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_APEX_H
#define GRAZE_CURVED_APEX_H

#include "decide/curved/sign_germ.h"

/** Ask the one member whose gradient is zero, if its terms of degree two are not
 * (proofs/curved.md C99). `smooth`: all others. */
void apex_ask(sign_germ *g, unsigned smooth, int singular);

#endif
