/* Where an edge of a solid in E^3 is in contact at a time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTACT_EDGE_RUN_H
#define GRAZE_CONTACT_EDGE_RUN_H

#include "questions/contact/nearby.h"
#include "questions/contact/speed.h"

/**
 * Try the nearest point of the contact set of the edge between two corners (proofs/snap.md
 * C75).
 * @return GRAZE_EINPUT other than two facets meet along it
 */
graze_status edge_run_try(nearby *n, graze_context *context, const graze_solid *solid,
                          const fmpq *u, const fmpq *v, const speed *s);

#endif
