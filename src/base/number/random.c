/* SplitMix64.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/random.h"

static uint64_t next_word(random_stream *r) {
    uint64_t z = r->state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

void random_seed(random_stream *r, uint64_t seed, uint64_t row) {
    r->state = seed;
    r->state = next_word(r) ^ row;
    r->state = next_word(r);
}

size_t random_below(random_stream *r, size_t n) {
    return (size_t)(next_word(r) % n);
}
