/* The floating-point environment of Graze, independent of the host's.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * FLINT's modular arithmetic and CGAL's filters need rounding to nearest; under another mode FLINT
 * factors wrongly. Every public function that computes opens with PUBLIC (api/api.h) or
 * IN_ENVIRONMENT (scope.h).
 */
#ifndef GRAZE_CONTEXT_ENVIRONMENT_H
#define GRAZE_CONTEXT_ENVIRONMENT_H

#include <fenv.h>
#include <mpfr.h>

/** The host's settings: rounding mode, traps, flushing of subnormals, exception flags, and MPFR's
 * range of exponents. */
typedef struct environment {
    fenv_t host;
    mpfr_exp_t least, largest;
} environment;

/** Set the default environment for this thread: to nearest, no traps, subnormals kept, MPFR's
 * default range of exponents. @return the host's settings, for environment_leave */
environment environment_enter(void);

/** Restore the host's settings. */
void environment_leave(const environment *saved);

#endif
