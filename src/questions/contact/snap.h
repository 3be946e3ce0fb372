/* The contact set of a boundary cell at a time, and the point of it that is nearest to another.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTACT_SNAP_H
#define GRAZE_CONTACT_SNAP_H

#include "questions/contact/nearby.h"
#include "questions/contact/site_record.h"

/**
 * Find the nearest point of the contact set of a cell at t (proofs/snap.md C75); of a vertex
 * its position, whatever its role.
 * @param[in,out] n without a point yet; none is found where the set is empty
 * @return GRAZE_EINPUT t is not a time of the motion, the solid has no such cell, or more than two
 * facets meet along an edge; GRAZE_ELIMIT; GRAZE_ESYSTEM
 */
graze_status snap_find(nearby *n, graze_context *context, const graze_scene *scene, const fmpq_t t,
                       const graze_cell *cell);

#endif
