/* Tests a span of a curve against a simplex: certainly no contact, one certain crossing, or a
 * question for the exact path. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_MEET_H
#define GRAZE_FILTER_MEET_H

#include "decide/filter/curve.h"
#include "decide/filter/span_pullback.h"

typedef enum meeting {
    MEET_NONE,     /* no time of the closed span is on the closed simplex */
    MEET_CROSSING, /* one time is, in its relative interior; the curve crosses to the other side */
    MEET_ASK,      /* not certain; every time on the simplex lies in the window */
    MEET_CUT       /* as MEET_ASK, but halves of the span may decide */
} meeting;

/**
 * @param corner d corners of d coordinates, outward oriented (validate.h)
 * @param corner_error each is within it of the exact coordinate */
meeting meet_simplex(meet_window *out, const curve *c, const span *piece, const double *corner,
                     double corner_error);

/** The sides of a simplex at the times of a window at which the curve is in its plane
 * (proofs/doubles.md C65).
 * @param[out] inside bit k: the curve is certainly on the inner side of side k
 * @return 0 if the curve is certainly beyond a side, and so off the simplex */
int sides_meet(unsigned *inside, const curve *c, const span *piece, const double *corner,
               double corner_error, const meet_window *at);

#endif
