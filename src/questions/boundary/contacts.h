/* Contact points of a boundary.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_BOUNDARY_CONTACTS_H
#define GRAZE_BOUNDARY_CONTACTS_H

#include "questions/boundary/sampling.h"

/** Make contact points and keep the places of those that are `on`. */
graze_status boundary_contacts(graze_context *context, struct graze_boundary *b,
                               unsigned long count, unsigned long long seed);
/** 1 if the cell holds such a point. */
int sample_cell_has_contact(const struct graze_boundary *b, const sample_cell *c);

#endif
