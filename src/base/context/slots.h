/* A hash table of numbers 0, 1, 2, ... in the order in which they came; whose keys they are is the
 * caller's. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTEXT_SLOTS_H
#define GRAZE_CONTEXT_SLOTS_H

#include <stddef.h>
#include <stdint.h>

/** Zeroed: empty. Equal keys have equal hashes. */
typedef struct slots {
    struct slot *slot; /* with linear steps; at most half in use */
    size_t size;       /* a power of two */
    size_t count;
} slots;

/** No number. */
#define SLOTS_NONE SIZE_MAX

/** Mix a key's bits, so that near keys are far apart; different keys stay different. */
uint64_t slots_mix(uint64_t key);

/**
 * The numbers with a hash, one after another; SLOTS_NONE behind the last.
 * @param[in,out] at 0 for the first; then left alone
 */
size_t slots_next(const slots *t, uint64_t hash, size_t *at);
/** Add the number `count` with a hash; 0 when memory is short, then nothing has changed. */
int slots_add(slots *t, uint64_t hash);
void slots_clear(slots *t);

#endif
