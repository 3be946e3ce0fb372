/* Query points that touch a polyhedron or a polygon.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_STRAIGHT_CONTACT_H
#define GRAZE_GENERATE_STRAIGHT_CONTACT_H

#include "questions/generate/generator.h"

/** As stratum_contact, which is 0 if this try made none. */
int straight_contact(sample *out, fmpq *normal, const struct graze_generator *g,
                     graze_stratum stratum, random_stream *r);

#endif
