/* Explains to a person the directions about a point that each of its contacts covers.
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

/** Append the time of a contact, and its boundary cell. */
void closings_place(text *t, const graze_scene *scene, const germ *g);

/** Append a line for each contact of an `on` point; for an unsweep the solid's complement is what
 * covers. If the position is undecided, append the nearest point found that is out. */
graze_status closings_explain(text *t, graze_context *context, const graze_scene *scene,
                              const fmpq *point, const topo_finding *topo);

#endif
