/* A gap between what contacts cover below and above a plane, thinner than every cone.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_THIN_GAP_H
#define GRAZE_TOPO_THIN_GAP_H

#include "questions/topo/half.h"

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
 * Set the order and the lift of a gap in a direction of a quarter, which is taken as b's numerator
 * and denominator say.
 * @param item germs whose valid leading terms are consistent: each `above` term is at least each
 * `below` term
 */
graze_status gap_set(plane_gap *gap, const open_plane *h, graze_context *context,
                     const half_germ *item, size_t count, half_quarter quarter, const fmpq_t b);

#endif
