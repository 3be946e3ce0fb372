/* Query points whose signed distance lies in a stated decade, on a stated side.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_LEVEL_H
#define GRAZE_GENERATE_LEVEL_H

#include "questions/generate/strata.h"

/**
 * Find the decades of |s| that the scene has points of, on each side: those of `in` points from the
 * largest down to 1e-9 of the diagonal, and the same ones of `out` points. Those among them that no
 * try finds are the missing ones.
 * @return GRAZE_ELIMIT the scene is beyond what distances are computed for; GRAZE_ECANCELED,
 * GRAZE_ESYSTEM
 */
graze_status levels_find(struct graze_generator *g, graze_context *context);

/** Try once for a point of one of these: an `on` point of a contact, displaced along the normal,
 * whose enclosure lies in the decade. *made is 0 if this try made none. */
graze_status level_try(int *made, sample *out, graze_context *context,
                       const struct graze_generator *g, random_stream *r);

#endif
