/* What a picture in doubles can show.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_RANGE_H
#define GRAZE_DRAW_RANGE_H

#include "base/context/context.h"

/** Can doubles hold a box of `count` coordinates, and differences in it to less than a pixel?
 * @return GRAZE_ELIMIT if not */
graze_status range_check(graze_context *context, const double *low, const double *high, int count);

#endif
