/* Declarations shared by the files of the public functions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_API_INTERNAL_H
#define GRAZE_API_INTERNAL_H

#include "graze.h"
#include <flint/fmpq.h>
#include <stddef.h>
#include "base/context/context.h"
#include "decide/scene/scene.h"

/** The message of a wrong call; GRAZE_EUSE also where there is no context to hold it. */
graze_status api_misuse(graze_context *context, const char *function, const char *reason);

/** GRAZE_EINPUT: a function, or an option, that takes polyhedra alone was given a curved solid. */
graze_status api_curved(graze_context *context, const char *function);
/** GRAZE_EINPUT: a function that needs a box of the solid was given a curved one without. */
graze_status api_unbounded(graze_context *context, const char *function);

/**
 * Check a caller's rational.
 * @return GRAZE_EUSE it is not in lowest terms with a positive denominator; GRAZE_ELIMIT it has
 * more digits than the limit allows
 */
graze_status api_rational_check(graze_context *context, const mpq_t value);

/** Check a caller's rational and take it over. */
graze_status api_rational(fmpq_t out, graze_context *context, const mpq_t value);

/** Check a caller's point and take it over, into d rationals; the place of a failure is recorded.
 */
graze_status api_point(fmpq *out, graze_context *context, const graze_scene *scene,
                       graze_rationals point);

/** Put item and coordinate before a message and record the place; `item` may be NULL. */
graze_status api_coordinate(graze_context *context, graze_status status, const char *item,
                            size_t index, size_t coordinate);

/**
 * Copy the caller's options, whose first member is their size in bytes; the other members become
 * zero, and all do for NULL.
 * @param known size of the struct in this version
 * @return GRAZE_EUSE a size too small, or members that this version does not know
 */
graze_status api_options(void *out, size_t known, graze_context *context, const char *function,
                         const void *options);

/** Hand a rational to the caller's initialised variable. */
void api_rational_out(mpq_t out, const fmpq_t value);

#endif
