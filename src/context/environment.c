/* Saves and restores the floating-point environment.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "context/environment.h"

environment environment_enter(void) {
    environment saved;
    fegetenv(&saved.host);
    fesetenv(FE_DFL_ENV);
    return saved;
}

void environment_leave(const environment *saved) {
    fesetenv(&saved->host);
}
