/* Names. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/judge/judge.h"

const char *mesh_rule_name(graze_mesh_rule rule) {
    return rule == GRAZE_MESH_WINDING ? "winding" : rule == GRAZE_MESH_PARITY ? "parity" : "none";
}
