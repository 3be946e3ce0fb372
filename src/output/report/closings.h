/* What each contact of a point closes about it, for a person.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_CLOSINGS_H
#define GRAZE_REPORT_CLOSINGS_H

#include "base/number/text.h"
#include "decide/scene/scene.h"
#include "questions/topo/finding.h"
#include "questions/topo/germ.h"

/** Append a linear form of a direction, such as `dx + -2 dy`. */
void closings_form(text *t, const fmpz *normal, int dimension);

/** Append the time of a contact, and the cell in which it is. */
void closings_place(text *t, const graze_scene *scene, const germ *g);

/** Append a line for each contact of an `on` point, of an unsweep of what is outside the solid; and
 * where the position is undecided, the nearest point found that is beyond it. */
graze_status closings_explain(text *t, graze_context *context, const graze_scene *scene,
                              const fmpq *point, const topo_finding *topo);

#endif
