/* The random numbers of the tests in C: FLINT's generator, begun from a seed, so that runs repeat.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TESTS_LIB_RANDOM_H
#define GRAZE_TESTS_LIB_RANDOM_H

#include <flint/flint.h>
#include <flint/ulong_extras.h>

/* The generator, which FLINT's functions fmpz_randtest and the like take too. */
static flint_rand_t chance;

/* Begin the sequence of a seed. */
static inline void random_start(ulong seed) {
    static int begun;
    if (begun)
        flint_randclear(chance);
    flint_randinit(chance);
    flint_randseed(chance, seed, 1);
    begun = 1;
}

/* An integer from 0 to n - 1. */
static inline slong draw_below(slong n) {
    return (slong)n_randint(chance, (ulong)n);
}

/* An integer from -range to range. */
static inline slong random_about(slong range) {
    return draw_below(2 * range + 1) - range;
}

/* In [-1, 1), with 53 random bits. */
static inline double random_fraction(void) {
    return (double)(n_randlimb(chance) >> 11) * 0x1p-52 - 1;
}

#endif
