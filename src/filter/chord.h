/* Whether a span's thick chord misses one simplex: what spares most pairs the Bernstein forms.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_CHORD_H
#define GRAZE_FILTER_CHORD_H

#include "filter/curve.h"

/** Only CHORD_MISSES is a statement; the others say what is worth trying next. */
typedef enum chord_meeting {
    CHORD_MISSES,  /* no time of the closed span is on the closed simplex */
    CHORD_PIERCES, /* all of the thick chord seems to go through the interior */
    CHORD_NEAR     /* it is too thick to tell */
} chord_meeting;

/**
 * @param corner d corners of d coordinates, outward oriented (validate.h)
 * @param corner_error each is within it of the exact coordinate
 */
chord_meeting chord_meets(const curve *c, const span *piece, const double *corner,
                          double corner_error);

#endif
