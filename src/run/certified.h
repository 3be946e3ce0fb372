/* The intervals of a certificate's row, held to its word.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_CERTIFIED_H
#define GRAZE_RUN_CERTIFIED_H

#include "run/row.h"

/** How far the intervals of a row have come. Zeroed at first; certified_clear frees it. */
typedef struct certified {
    char *word; /* malloc'ed */
    size_t length, capacity;
    size_t at; /* the letter they have come to */
    int begun, ended;
} certified;

void certified_clear(certified *c);
/** Begin with the intervals of a row with this word; 0 without memory. */
int certified_begin(certified *c, field word);
/**
 * Check the next interval's line: its form, and that the intervals spell the word. graze-check
 * verifies their claims.
 * @return NULL, or what is expected; `ended` is set behind the interval up to the last time
 */
const char *certified_interval(certified *c, const row_form *form, field line);

#endif
