/* Numbers texts by a hash table with linear steps.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/table/texts.h"

#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"

void texts_clear(texts *t) {
    text_clear(&t->bytes);
    free(t->end);
    free(t->slot);
    *t = (texts){0};
}

field texts_at(const texts *t, uint32_t number) {
    size_t start = number ? t->end[number - 1] : 0;
    return (field){t->bytes.data + start, t->end[number] - 1 - start};
}

/* FNV-1a, mixed once more, as the low bits choose the slot. */
static uint64_t hash_of(field one) {
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (size_t k = 0; k < one.length; k++)
        hash = (hash ^ (unsigned char)one.start[k]) * UINT64_C(0x100000001b3);
    return hash ^ hash >> 32;
}

/* The slot that holds a text, or the empty one where it would go. */
static uint32_t *slot_of(const texts *t, field one) {
    size_t at = hash_of(one) & (t->slots - 1);
    while (t->slot[at] && !field_equal(texts_at(t, t->slot[at] - 1), one))
        at = (at + 1) & (t->slots - 1);
    return &t->slot[at];
}

static int grow_text_slots(texts *t) {
    size_t slots = t->slots ? 2 * t->slots : 128;
    uint32_t *slot = calloc(slots, sizeof *slot);
    if (!slot)
        return 0;
    free(t->slot);
    t->slot = slot;
    t->slots = slots;
    for (size_t k = 0; k < t->count; k++)
        *slot_of(t, texts_at(t, (uint32_t)k)) = (uint32_t)k + 1;
    return 1;
}

int texts_number(uint32_t *out, texts *t, field one) {
    if ((2 * t->count == t->slots && !grow_text_slots(t)) ||
        !array_reserve(&t->end, &t->capacity, t->count + 1, sizeof *t->end))
        return 0;
    uint32_t *slot = slot_of(t, one);
    if (!*slot) {
        text_bytes(&t->bytes, one.start, one.length);
        text_bytes(&t->bytes, "\n", 1);
        if (t->bytes.failed || t->count == UINT32_MAX)
            return 0;
        t->end[t->count++] = t->bytes.length;
        *slot = (uint32_t)t->count;
    }
    *out = *slot - 1;
    return 1;
}
