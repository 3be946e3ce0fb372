/* A gap along a plane between the germs below and above it, thinner than every cone: a cusp.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_PLANE_GAP_H
#define GRAZE_TOPO_PLANE_GAP_H

#include "questions/topo/half.h"

/** A curve into the gap, if `order` is not 0: by leading terms no germ covers the places P +
 * s^order along + s^(order + 1) lift N for small s > 0, where N is the plane's normal. */
typedef struct plane_gap {
    fmpz along[3];
    slong order;
    fmpq lift;
} plane_gap;

void gap_init(plane_gap *gap);
void gap_clear(plane_gap *gap);

/** Set a gap in the direction that b is in the chart; `along` is that direction times b's
 * denominator. The order remains 0 if the leading terms leave no room.
 * @param item germs whose valid leading terms are consistent: each `above` term is at least each
 * `below` term */
graze_status gap_set(plane_gap *gap, const open_plane *h, graze_context *context,
                     const half_germ *item, size_t count, direction_chart chart, const fmpq_t b);

#endif
