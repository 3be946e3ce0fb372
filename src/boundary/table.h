/* Numbers in the order in which they came, found again by hashing.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_BOUNDARY_TABLE_H
#define GRAZE_BOUNDARY_TABLE_H

#include <stddef.h>
#include <stdint.h>

/** Keys with a byte each. Zeroed: empty. */
typedef struct table {
    uint64_t *key;
    unsigned char *value;
    size_t count, capacity;
    size_t *slot; /* index + 1, or 0; a power of two of them, at most half in use */
    size_t slots;
} table;

void table_clear(table *t);
/** The index of a key, or `count` if it is not there. */
size_t table_find(const table *t, uint64_t key);
/** Add a key that is not there; 0 when memory is short. */
int table_add(table *t, uint64_t key, unsigned char value);

#endif
