/* A hash table of the numbers 0, 1, 2, ..., added in this order, each with the hash of a key. The
 * caller keeps the keys and compares them. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTEXT_SLOTS_H
#define GRAZE_CONTEXT_SLOTS_H

#include <stddef.h>
#include <stdint.h>

/** A zeroed structure is an empty table. Equal keys must have equal hashes. */
typedef struct slots {
    struct slot *slot; /* linear probing; at most half are in use */
    size_t size;       /* a power of two */
    size_t count;
} slots;

/** No number. */
#define SLOTS_NONE SIZE_MAX

/** Mix a key's bits, so that near keys are far apart; different keys stay different. */
uint64_t slots_mix(uint64_t key);

/**
 * Return the next number that was added with this hash; SLOTS_NONE after the last one.
 * @param[in,out] at 0 before the first call; the caller does not change it afterwards
 */
size_t slots_next(const slots *t, uint64_t hash, size_t *at);
/** Add the number `count` with a hash, and increase `count`. @return 0 if memory is short, and then
 * nothing has changed; else 1 */
int slots_add(slots *t, uint64_t hash);
void slots_clear(slots *t);

#endif
