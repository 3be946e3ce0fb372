/* Different texts, numbered from 0 in the order in which they first come.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TABLE_TEXTS_H
#define GRAZE_TABLE_TEXTS_H

#include "base/context/slots.h"
#include "base/number/text.h"
#include "input/delimited/field.h"

/** Zeroed: none. */
typedef struct texts {
    text bytes;  /* one text after another, each with a newline behind it */
    size_t *end; /* of each text in the bytes, behind its newline */
    size_t count, capacity;
    slots numbers;
} texts;

void texts_clear(texts *t);
/** The number of a text without a newline, which is added if it is not there yet; 0 when memory is
 * short or there are 2^32 - 1 texts. */
int texts_number(uint32_t *out, texts *t, field one);
/** A text by its number. */
field texts_at(const texts *t, uint32_t number);

#endif
