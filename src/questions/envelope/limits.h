/* Patches that meet at a moment.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_LIMITS_H
#define GRAZE_ENVELOPE_LIMITS_H

#include "questions/envelope/patch_ends.h"

/** Add the joints at moments within the motion: of patches that begin or end then, by the limits of
 * the places where they end, with those that go on there (proofs/events.md C85). */
graze_status limits_find(graze_patches *p, graze_context *context, const place_list *places);

#endif
