/* Where a facet is in contact at a time: g <= 0 after it and g >= 0 before it, g = 0 within a piece
 * of the motion. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTACT_FACET_SLICE_H
#define GRAZE_CONTACT_FACET_SLICE_H

#include "questions/contact/nearby.h"
#include "questions/contact/speed.h"

/** Try the nearest point of the contact set of a simplex of the boundary (proofs/snap.md C75). */
void facet_slice_try(nearby *n, const graze_solid *solid, size_t simplex, const speed *s);

#endif
