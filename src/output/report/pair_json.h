/* How two solids meet, as JSON (src/program/cli/formats.md, Collisions).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_PAIR_JSON_H
#define GRAZE_REPORT_PAIR_JSON_H

#include "base/number/json.h"
#include "questions/collide/collide.h"

/** "clear", "touch", "overlap", "meets", else "none". Static. */
const char *pair_verdict_name(graze_pair_verdict verdict);
/** "vertex-facet" and so on, the moving one first; "" for none. Static. */
const char *cell_pair_name(const graze_cell_pair *cells);

/** Append the object of a pair. */
void pair_json(text *out, const graze_pair *pair);

#endif
