/* What the files of the public functions share.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_API_INTERNAL_H
#define GRAZE_API_INTERNAL_H

#include "graze.h"
#include <flint/fmpq.h>
#include "context/context.h"
#include "scene/scene.h"

/** The message of a wrong call; GRAZE_EUSE also where there is no context to hold it. */
graze_status api_misuse(graze_context *context, const char *function, const char *reason);

/**
 * Take a caller's rational over.
 * @return GRAZE_EUSE it is not in lowest terms with a positive denominator; GRAZE_ELIMIT it has
 * more digits than the limit allows
 */
graze_status api_rational(fmpq_t out, graze_context *context, const mpq_t value);

/** Hand a rational or an integer to the caller's initialised variable. */
void api_rational_out(mpq_t out, const fmpq_t value);

#endif
