/* The patches of an envelope: cells with the intervals of time in which they are in contact.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_PATCHES_H
#define GRAZE_ENVELOPE_PATCHES_H

#include "questions/envelope/patch.h"

/** @param[out] out uninitialised; patches_clear after GRAZE_OK */
graze_status patches_make(graze_patches *out, graze_context *context,
                          const graze_envelope *envelope);
void patches_clear(graze_patches *p);

#endif
