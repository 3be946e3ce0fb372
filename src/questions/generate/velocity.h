/* Normal velocities of a simplex's corners at an instant, in doubles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_VELOCITY_H
#define GRAZE_GENERATE_VELOCITY_H

#include <stddef.h>
#include "questions/generate/instant.h"

/**
 * Whether the first derivative of the pullback of a simplex's plane certainly has one sign at all
 * its corners, and so nowhere on the simplex the value 0 (proofs/doubles.md C64).
 * @return 0 if it has not, or that is not certain
 */
int velocity_has_one_sign(const instant *i, const graze_solid *solid, size_t simplex);

#endif
