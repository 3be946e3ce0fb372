/* A stream of random numbers that depends on a seed and a row alone, the same on every machine.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_RANDOM_H
#define GRAZE_NUMBER_RANDOM_H

#include <stddef.h>
#include <stdint.h>

/** SplitMix64 (Steele, Lea, Flood 2014). */
typedef struct random_stream {
    uint64_t state;
} random_stream;

/** Begin the stream of one row. Rows do not depend on each other, so any row can be made alone. */
void random_seed(random_stream *r, uint64_t seed, uint64_t row);

/** A number from 0 to n - 1, n >= 1; the bias is below n / 2^64. */
size_t random_below(random_stream *r, size_t n);

#endif
