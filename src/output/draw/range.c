/* Limits of pictures. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/draw/range.h"

#include <math.h>

static const double LEAST_SIZE = 1e-300, MOST_COORDINATE = 1e300, FARTHEST = 0x1p42;

graze_status range_check(graze_context *context, const double *low, const double *high, int count) {
    double size = 0, most = 0;
    for (int k = 0; k < count; k++) {
        size = fmax(size, high[k] - low[k]);
        most = fmax(most, fmax(fabs(low[k]), fabs(high[k])));
    }
    if (size >= LEAST_SIZE && most <= MOST_COORDINATE && most <= FARTHEST * size)
        return GRAZE_OK;
    return context_fail(context, GRAZE_ELIMIT,
                        "the picture's coordinates are beyond what doubles can draw; expected at "
                        "most 1e300, and a size of at least 1e-300 and 2^-42 of the largest");
}
