/* Tests whether a span's thick chord misses a simplex; for most pairs this spares the Bernstein
 * forms. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_CHORD_H
#define GRAZE_FILTER_CHORD_H

#include <math.h>
#include "decide/filter/curve.h"
#include "decide/filter/flip.h"
#include "decide/filter/normal.h"
#include "input/solid/slabs.h"

/** Only CHORD_MISSES is proved; the others suggest the next test. */
typedef enum chord_meeting {
    CHORD_MISSES,  /* no time of the closed span is on the closed simplex */
    CHORD_PIERCES, /* all of the thick chord seems to go through the interior */
    CHORD_NEAR     /* it is too thick to tell */
} chord_meeting;

/**
 * @param corner d corners of d coordinates, outward oriented (validate.h)
 * @param corner_error each is within it of the exact coordinate */
chord_meeting chord_meets(const curve *c, const span *piece, const double *corner,
                          double corner_error);

/**
 * 0 if it is certain that a bounded span meets no simplex of the slab (proofs/slabs.md C93).
 * @param wide the span's, or a larger one, for all curves that are that near its chord */
static inline int chord_meets_slab(const span *piece, const double wide[3], const slab *s) {
    double first = 0, last = 0, bound = 0;
    for (int i = 0; i < 3; i++) {
        first += s->normal[i] * piece->from[i];
        last += s->normal[i] * piece->end[i];
        bound += fabs(s->normal[i]) * wide[i];
    }
    bound = FILTER_SLACK * bound + FILTER_FLOOR;
    return !flip(FLIP_SLAB, (first - bound > s->high && last - bound > s->high) ||
                                (first + bound < s->low && last + bound < s->low));
}

#endif
