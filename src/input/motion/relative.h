/* One motion seen from another. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_MOTION_RELATIVE_H
#define GRAZE_MOTION_RELATIVE_H

#include "input/motion/motion.h"

/**
 * frame^-1 moving ([IS] eq. 7) over the times that both have.
 * @return GRAZE_EILLEGAL the dimensions differ, or there is no interval that both have;
 * GRAZE_ELIMIT
 */
graze_status motion_relative(graze_motion **out, graze_context *context, const graze_motion *moving,
                             const graze_motion *frame);

#endif
