/* Names of roles, trims and orientations.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/names.h"
#include "graze/contact.h"

const char *graze_role_name(graze_role role) {
    static const char *const names[] = {
        [GRAZE_ROLE_CONTACT] = "contact",
        [GRAZE_ROLE_EGRESS] = "egress",
        [GRAZE_ROLE_INGRESS] = "ingress",
        [GRAZE_ROLE_HIDDEN] = "hidden",
    };
    return name_at(names, sizeof names / sizeof *names, (size_t)role);
}

const char *graze_trim_name(graze_trim trim) {
    static const char *const names[] = {
        [GRAZE_TRIM_SLIDES] = "slides",   [GRAZE_TRIM_SIMPLE] = "simple",
        [GRAZE_TRIM_MEETS] = "meets",     [GRAZE_TRIM_NEAR] = "trimmed_near",
        [GRAZE_TRIM_FAR] = "trimmed_far",
    };
    return name_at(names, sizeof names / sizeof *names, (size_t)trim);
}

const char *graze_orientation_name(graze_orientation orientation) {
    static const char *const names[] = {
        [GRAZE_ORIENTATION_PRESERVING] = "preserving",
        [GRAZE_ORIENTATION_REVERSING] = "reversing",
        [GRAZE_ORIENTATION_DEGENERATE] = "degenerate",
    };
    return name_at(names, sizeof names / sizeof *names, (size_t)orientation);
}
