/* Patches that meet, where and when.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_JOINTS_H
#define GRAZE_ENVELOPE_JOINTS_H

#include "questions/envelope/patch.h"

/** Find the joints of patches that are complete (proofs/events.md C85). */
graze_status joints_find(graze_patches *p, graze_context *context);

#endif
