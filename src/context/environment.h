/* The floating-point environment that Graze computes in, whatever the host has set.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * FLINT's modular arithmetic and CGAL's filters take rounding to nearest for granted; under another
 * mode FLINT was seen to factor wrongly. Every public function that computes opens with
 *     __attribute__((cleanup(environment_leave), unused)) environment host = environment_enter();
 */
#ifndef GRAZE_CONTEXT_ENVIRONMENT_H
#define GRAZE_CONTEXT_ENVIRONMENT_H

#include <fenv.h>
#include <mpfr.h>

/** What the host had set: rounding mode, traps, flushing of subnormals, exception flags, and MPFR's
 * range of exponents. */
typedef struct environment {
    fenv_t host;
    mpfr_exp_t least, largest;
} environment;

/** Set the default environment for this thread: to nearest, no traps, subnormals kept, MPFR's whole
 * range. */
environment environment_enter(void);

/** Give the host its own back. */
void environment_leave(const environment *saved);

#endif
