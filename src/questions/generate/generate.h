/* Query points made to be degenerate: a body point y and a rational time are chosen, and P = M(t)
 * y. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_GENERATE_H
#define GRAZE_GENERATE_GENERATE_H

#include "questions/generate/strata.h"

/** Make a generator; `out` is cleared by generator_clear in either case. */
graze_status generator_make(struct graze_generator *out, graze_context *context,
                            const graze_scene *scene, uint64_t seed, const unsigned long *weights,
                            int representable);
void generator_clear(struct graze_generator *g);

/** The point of one row; it depends on generator and row alone.
 * @return GRAZE_OK but for the stratum `level`: GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM */
graze_status generator_sample(sample *out, graze_context *context, const struct graze_generator *g,
                              uint64_t row);

#endif
