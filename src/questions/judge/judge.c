/* Names. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/judge/judge.h"

const char *mesh_rule_name(mesh_rule rule) {
    return rule == MESH_RULE_WINDING ? "winding" : rule == MESH_RULE_PARITY ? "parity" : "none";
}
