/* One turn to an angle in degrees.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_TURN_H
#define GRAZE_CONVERT_TURN_H

#include "input/convert/conversion.h"
#include "input/convert/joint.h"

/** One turn at no particular speed; only its end is approximated. */
graze_status convert_rotation(conversion *out, graze_context *context, const target *goal,
                              const joint *turn);

#endif
