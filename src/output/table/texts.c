/* Numbers texts by their hashes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/table/table.h"

#include <stdlib.h>
#include "base/context/array.h"

void texts_clear(texts *t) {
    text_clear(&t->bytes);
    free(t->end);
    slots_clear(&t->numbers);
    *t = (texts){0};
}

field texts_at(const texts *t, uint32_t number) {
    size_t start = number ? t->end[number - 1] : 0;
    return (field){t->bytes.data + start, t->end[number] - 1 - start};
}

/* The hash FNV-1a, mixed once more, since its low bits choose the slot. */
static uint64_t hash_of(field one) {
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (size_t k = 0; k < one.length; k++)
        hash = (hash ^ (unsigned char)one.start[k]) * UINT64_C(0x100000001b3);
    return hash ^ hash >> 32;
}

static int keep_text(texts *t, field one, uint64_t hash) {
    if (t->count == UINT32_MAX ||
        !array_reserve(&t->end, &t->capacity, t->count + 1, sizeof *t->end))
        return 0;
    text_bytes(&t->bytes, one.start, one.length);
    text_bytes(&t->bytes, "\n", 1);
    if (t->bytes.failed || !slots_add(&t->numbers, hash))
        return 0;
    t->end[t->count++] = t->bytes.length;
    return 1;
}

int texts_number(uint32_t *out, texts *t, field one) {
    uint64_t hash = hash_of(one);
    size_t at = 0, number;
    do
        number = slots_next(&t->numbers, hash, &at);
    while (number != SLOTS_NONE && !field_equal(texts_at(t, (uint32_t)number), one));
    *out = (uint32_t)(number == SLOTS_NONE ? t->count : number);
    return number != SLOTS_NONE || keep_text(t, one, hash);
}
