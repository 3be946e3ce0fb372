/* Saves and restores the floating-point environment.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/environment.h"

environment environment_enter(void) {
    environment saved;
    fegetenv(&saved.host);
    fesetenv(FE_DFL_ENV);
    saved.least = mpfr_get_emin();
    saved.largest = mpfr_get_emax();
    mpfr_set_emin(MPFR_EMIN_DEFAULT);
    mpfr_set_emax(MPFR_EMAX_DEFAULT);
    return saved;
}

void environment_leave(const environment *saved) {
    fesetenv(&saved->host);
    mpfr_set_emin(saved->least);
    mpfr_set_emax(saved->largest);
}
