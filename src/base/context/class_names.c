/* Names of positions and classes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/names.h"
#include "graze/core.h"

const char *graze_pmc_name(graze_pmc pmc) {
    static const char *const names[] = {
        [GRAZE_IN] = "in",
        [GRAZE_ON] = "on",
        [GRAZE_OUT] = "out",
        [GRAZE_PMC_UNDECIDED] = "undecided",
    };
    return name_at(names, sizeof names / sizeof *names, (size_t)pmc);
}

const char *graze_class_name(graze_class class_) {
    static const char *const names[] = {
        [GRAZE_REGULAR] = "regular",
        [GRAZE_FOLD] = "fold",
        [GRAZE_FOLD_BOUNDARY] = "fold_boundary",
        [GRAZE_BOUNDARY] = "boundary",
        [GRAZE_EXTERIOR] = "exterior",
        [GRAZE_CLASS_UNDECIDED] = "undecided",
    };
    return name_at(names, sizeof names / sizeof *names, (size_t)class_);
}
