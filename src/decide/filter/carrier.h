/* Point maps of a motion in doubles, which carry query points in the filter.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_CARRIER_H
#define GRAZE_FILTER_CARRIER_H

#include "base/number/dyadic.h"
#include "input/motion/motion.h"

/** Polynomials of higher degree are left to the exact path. */
enum { CARRIER_DEGREE = 32 };

/** The filter's unit of rounding, 2^-53 (proofs/filter.md C32). */
#define UNIT_ROUNDING 0x1p-53

/** Larger numbers are left to the exact path, so that no product leaves the range of doubles. */
#define CARRIER_REACH 0x1p200

/** A point map on [0, 1], all its polynomials scaled by one positive number so that the largest
 * Bernstein coefficient of the weight lies in [1/2, 1). Each number differs from the exact one by
 * at most 2^-52 of itself. */
typedef struct carrier {
    int usable;            /* 0: nothing below is set; degree or size is beyond the filter */
    int dimension, degree; /* degree >= 1 */
    double *entry;         /* coefficient k of entry (i, j) at (i (d + 1) + j)(degree + 1) + k */
    double *weight;        /* degree + 1 coefficients; behind the entries, freed with them */
    struct carrier *half;  /* its two halves, if a weight is too small to divide by, recursively to
                              some level; else NULL; freed with it */
} carrier;

/** Weights up to this are too small to divide by. */
#define CARRIER_LEAST_WEIGHT 0x1p-40

/** Convert a map, with halves; 0 if memory runs out, else 1. */
int carrier_make(carrier *out, const point_map *map);
/** Convert a map on a dyadic part of [0, 1], on which the parameter runs from 0 to 1, without
 * halves. */
int carrier_make_on(carrier *out, const point_map *map, const dyadic_interval *part);
void carrier_clear(carrier *c);

#endif
