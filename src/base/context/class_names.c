/* Names of positions and classes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "graze/core.h"

const char *graze_pmc_name(graze_pmc pmc) {
    switch (pmc) {
    case GRAZE_IN:
        return "in";
    case GRAZE_ON:
        return "on";
    case GRAZE_OUT:
        return "out";
    default:
        return "none";
    }
}

const char *graze_class_name(graze_class class_) {
    switch (class_) {
    case GRAZE_REGULAR:
        return "regular";
    case GRAZE_FOLD:
        return "fold";
    case GRAZE_FOLD_BOUNDARY:
        return "fold_boundary";
    case GRAZE_BOUNDARY:
        return "boundary";
    case GRAZE_EXTERIOR:
        return "exterior";
    default:
        return "none";
    }
}
