/* Plane curves in coordinates about a point. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_TOPO_SHIFT_H
#define GRAZE_TOPO_SHIFT_H

#include "questions/topo/plane.h"

/** out = the curve at (x + P_x, y + P_y), primitive, for a point of 2 rationals; `curve` is not 0.
 */
graze_status shift_curve(fmpz_mpoly_t out, graze_context *context, const fmpz_mpoly_t curve,
                         const fmpq *point, const fmpz_mpoly_ctx_t ring);

#endif
