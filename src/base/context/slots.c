/* Open addressing. SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/slots.h"

#include <stdlib.h>

enum { FIRST_SIZE = 128 };

typedef struct slot {
    uint64_t hash;
    size_t number; /* the number plus 1; 0 if the slot is free */
} slot;

uint64_t slots_mix(uint64_t key) {
    uint64_t mixed = (key ^ key >> 31) * UINT64_C(0x9e3779b97f4a7c15);
    return mixed ^ mixed >> 32;
}

size_t slots_next(const slots *t, uint64_t hash, size_t *at) {
    while (t->size) {
        const slot *s = &t->slot[(hash + (*at)++) & (t->size - 1)];
        if (!s->number || s->hash == hash)
            return s->number - 1;
    }
    return SLOTS_NONE;
}

static void put_in(slot *to, size_t size, slot one) {
    size_t k = one.hash & (size - 1);
    while (to[k].number)
        k = (k + 1) & (size - 1);
    to[k] = one;
}

static int grow_slots(slots *t) {
    size_t size = t->size ? 2 * t->size : FIRST_SIZE;
    slot *larger = calloc(size, sizeof *larger);
    if (!larger)
        return 0;
    for (size_t k = 0; k < t->size; k++)
        if (t->slot[k].number)
            put_in(larger, size, t->slot[k]);
    free(t->slot);
    t->slot = larger;
    t->size = size;
    return 1;
}

int slots_add(slots *t, uint64_t hash) {
    if (2 * t->count == t->size && !grow_slots(t))
        return 0;
    put_in(t->slot, t->size, (slot){hash, ++t->count});
    return 1;
}

void slots_clear(slots *t) {
    free(t->slot);
    *t = (slots){0};
}
