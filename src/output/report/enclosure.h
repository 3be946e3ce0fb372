/* Enclosures of distances in tables, JSON and explanations.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_ENCLOSURE_H
#define GRAZE_REPORT_ENCLOSURE_H

#include "base/number/text.h"
#include "questions/distance/distance.h"

/** A bound as a decimal of at most 17 digits that is a bound too: not below the double if `up`,
 * else not above it. */
enum { BOUND_ROOM = 40 };
void report_bound(char out[BOUND_ROOM], double bound, int up);

/** The shortest decimal between a positive double and the next one, above it if `up`, else below
 * it: read towards the double it is that double again. */
void report_width(char out[BOUND_ROOM], double value, int up);

/** The time of an enclosure: a ratio, or a decimal of 17 digits where it is irrational, of a
 * contact.
 */
void report_distance_time(text *out, const graze_scene *scene, const distance *found);

/** Does the answer stay with every motion within the error? "yes", or "undecided". Static. */
const char *report_certainty(const distance *found, double motion_error);

/** Three columns, a comma before each. */
void report_distance(text *out, const graze_scene *scene, const distance *found);

/** A paragraph for a person. */
void explain_distance(text *out, const graze_scene *scene, const distance *found);

#endif
