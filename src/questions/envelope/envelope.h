/* The events of an envelope, and whether it decomposes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_ENVELOPE_H
#define GRAZE_ENVELOPE_ENVELOPE_H

#include "questions/envelope/envelope_record.h"

/** @param[out] out uninitialised; envelope_clear after GRAZE_OK */
graze_status envelope_make(graze_envelope *out, graze_context *context, const graze_scene *scene);
void envelope_clear(graze_envelope *e);

#endif
