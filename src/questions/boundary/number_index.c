/* Finds keys by their hashes; different keys have different hashes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/boundary/sampling.h"

#include <stdlib.h>
#include "base/context/array.h"

void number_index_clear(number_index *t) {
    free(t->key);
    free(t->value);
    slots_clear(&t->places);
}

size_t number_index_find(const number_index *t, uint64_t key) {
    size_t at = 0, index = slots_next(&t->places, slots_mix(key), &at);
    return index == SLOTS_NONE ? t->count : index;
}

int number_index_add(number_index *t, uint64_t key, unsigned char value) {
    size_t values = t->capacity; /* the true room is at least this: entries of `value` are smaller
                                    than those of `key` */
    if (!array_reserve(&t->value, &values, t->count + 1, sizeof *t->value) ||
        !array_reserve(&t->key, &t->capacity, t->count + 1, sizeof *t->key) ||
        !slots_add(&t->places, slots_mix(key)))
        return 0;
    t->key[t->count] = key;
    t->value[t->count++] = value;
    return 1;
}
