/* Numbers in the order in which they came, found again by hashing.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_BOUNDARY_NUMBER_INDEX_H
#define GRAZE_BOUNDARY_NUMBER_INDEX_H

#include "base/context/slots.h"

/** Keys with a byte each. Zeroed: empty. */
typedef struct number_index {
    uint64_t *key;
    unsigned char *value;
    size_t count, capacity;
    slots places; /* of the keys */
} number_index;

void number_index_clear(number_index *t);
/** The index of a key, or `count` if it is not there. */
size_t number_index_find(const number_index *t, uint64_t key);
/** Add a key that is not there; 0 when memory is short. */
int number_index_add(number_index *t, uint64_t key, unsigned char value);

#endif
