/* The contact points of facets, edges and vertices at one time, cell by cell.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_PARTS_H
#define GRAZE_ENVELOPE_PARTS_H

#include "questions/envelope/envelope_record.h"
#include "questions/envelope/snapshot.h"

/** The slice of a facet within its relative interior, or all of it. */
graze_status parts_of_facet(graze_curve *c, graze_context *context, const snapshot *s,
                            size_t facet);
/** Runs and single contacts in the relative interior of an edge (E^3), its ends added. */
graze_status parts_of_edge(graze_curve *c, graze_context *context, const snapshot *s, size_t edge);
/** A vertex that is a contact. */
graze_status parts_add_vertex(graze_curve *c, graze_context *context, const snapshot *s,
                              size_t vertex);
/** A vertex that is a contact and no end of another part. */
graze_status parts_of_vertex(graze_curve *c, graze_context *context, const snapshot *s,
                             size_t vertex);

/** Is a point in the facet, its border included? */
int parts_facet_holds(const cell_complex *c, size_t facet, const fmpq *at);

#endif
