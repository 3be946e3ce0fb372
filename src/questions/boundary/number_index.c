/* Open addressing with linear steps.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/boundary/number_index.h"

#include <stdlib.h>
#include "base/context/array.h"

void number_index_clear(number_index *t) {
    free(t->key);
    free(t->value);
    free(t->slot);
}

/* The slot that holds a key, or the empty one where it would go. */
static size_t key_slot(const number_index *t, uint64_t key) {
    uint64_t mixed = (key ^ (key >> 31)) * 0x9e3779b97f4a7c15u;
    size_t at = (size_t)(mixed >> 20) & (t->slots - 1);
    while (t->slot[at] && t->key[t->slot[at] - 1] != key)
        at = (at + 1) & (t->slots - 1);
    return at;
}

size_t number_index_find(const number_index *t, uint64_t key) {
    if (!t->slots)
        return t->count;
    size_t index = t->slot[key_slot(t, key)];
    return index ? index - 1 : t->count;
}

static int grow_slots(number_index *t) {
    size_t capacity = t->capacity, values = t->capacity;
    if (!array_reserve(&t->key, &capacity, t->count + 1, sizeof *t->key) ||
        !array_reserve(&t->value, &values, capacity, sizeof *t->value))
        return 0;
    size_t *slot = calloc(2 * capacity, sizeof *slot);
    if (!slot)
        return 0;
    free(t->slot);
    t->slot = slot;
    t->slots = 2 * capacity;
    t->capacity = capacity;
    for (size_t i = 0; i < t->count; i++)
        t->slot[key_slot(t, t->key[i])] = i + 1;
    return 1;
}

int number_index_add(number_index *t, uint64_t key, unsigned char value) {
    if (t->count == t->capacity && !grow_slots(t))
        return 0;
    t->key[t->count] = key;
    t->value[t->count] = value;
    size_t at = key_slot(t, key);
    t->slot[at] = t->count + 1;
    t->count++;
    return 1;
}
