/* Enclosures of distances in tables, JSON and explanations.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_ENCLOSURE_H
#define GRAZE_REPORT_ENCLOSURE_H

#include "base/number/text.h"
#include "questions/distance/distance.h"

/** Round a bound to a decimal of at most 17 digits that is a bound too: at least the double if
 * `up`, else at most the double. */
enum { BOUND_ROOM = 40 };
void report_bound(char out[BOUND_ROOM], double bound, int up);

/** Find the shortest decimal between a positive double and the next one, above it if `up`, else
 * below it. Rounded towards the double, it gives the double again. */
void report_width(char out[BOUND_ROOM], double value, int up);

/** Append the time of an enclosure: a ratio, or a decimal of 17 digits for an irrational time of a
 * contact.
 */
void report_distance_time(text *out, const graze_scene *scene, const distance *found);

/** Does every motion within the error have the same answer? "yes" or "undecided"; static. */
const char *report_certainty(const distance *found, double motion_error);

/** Append the three columns of an enclosure, a comma before each. */
void report_distance(text *out, const graze_scene *scene, const distance *found);

/** Append a paragraph about an enclosure for a person. */
void explain_distance(text *out, const graze_scene *scene, const distance *found);

#endif
