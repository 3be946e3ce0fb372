/* The comparison of a mesh with a sweep, as reports show it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_JUDGE_H
#define GRAZE_JUDGE_JUDGE_H

#include "graze/judge.h"
#include "questions/judge/suprema.h"

struct graze_mesh {
    soup input;
    judged_mesh judged;
};

struct graze_judgement {
    const graze_mesh *mesh; /* borrowed */
    suprema searched;
};

/** "none", "parity" or "winding". Static. */
const char *mesh_rule_name(graze_mesh_rule rule);

#endif
