/* Circuits: minimal sets of surfaces with linearly dependent gradients. Their relation excludes
 * patterns of signs near the point. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_CIRCUITS_H
#define GRAZE_CURVED_CIRCUITS_H

#include "decide/curved/sign_germ.h"

/** Ask all circuits of the members in `smooth`, whose gradients are not zero (proofs/curved.md C96
 * to C98). */
void circuits_ask(sign_germ *g, unsigned smooth);

#endif
