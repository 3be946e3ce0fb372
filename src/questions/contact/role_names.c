/* Names of roles, trims and orientations.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "graze/contact.h"

const char *graze_role_name(graze_role role) {
    switch (role) {
    case GRAZE_ROLE_CONTACT:
        return "contact";
    case GRAZE_ROLE_EGRESS:
        return "egress";
    case GRAZE_ROLE_INGRESS:
        return "ingress";
    case GRAZE_ROLE_HIDDEN:
        return "hidden";
    default:
        return "none";
    }
}

const char *graze_trim_name(graze_trim trim) {
    switch (trim) {
    case GRAZE_TRIM_SLIDES:
        return "slides";
    case GRAZE_TRIM_SIMPLE:
        return "simple";
    case GRAZE_TRIM_MEETS:
        return "meets";
    case GRAZE_TRIM_NEAR:
        return "trimmed_near";
    case GRAZE_TRIM_FAR:
        return "trimmed_far";
    default:
        return "none";
    }
}

const char *graze_orientation_name(graze_orientation orientation) {
    switch (orientation) {
    case GRAZE_ORIENTATION_PRESERVING:
        return "preserving";
    case GRAZE_ORIENTATION_REVERSING:
        return "reversing";
    case GRAZE_ORIENTATION_DEGENERATE:
        return "degenerate";
    default:
        return "none";
    }
}
