/* A gap between what contacts cover below and above a plane, thinner than every cone.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_GAP_H
#define GRAZE_TOPO_GAP_H

#include "topo/half.h"

/** Where `order` is not 0, the places P + s^order along + s^(order + 1) lift N, s > 0 and small,
 * lie by leading terms between what is covered below and above the plane across N. */
typedef struct plane_gap {
    fmpz along[3];
    slong order;
    fmpq lift;
} plane_gap;

void gap_init(plane_gap *gap);
void gap_clear(plane_gap *gap);

/**
 * Set the order and the lift of a gap along h + b k or, `swapped`, b h + k, times the denominator
 * of b; `along` is set to that.
 * @param item germs of which none above has its leading term there below that of one below
 */
void gap_set(plane_gap *gap, const open_plane *h, const half_germ *item, size_t count, int swapped,
             const fmpq_t b);

#endif
