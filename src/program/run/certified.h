/* The intervals and contacts of a certificate's row, held to its word.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_CERTIFIED_H
#define GRAZE_RUN_CERTIFIED_H

#include "program/run/row.h"

/** How far the intervals of a row have come. Zeroed at first; certified_clear frees it. */
typedef struct certified {
    char *word; /* malloc'ed */
    size_t length, capacity;
    size_t at;                 /* the letter they have come to */
    int begun, reached, ended; /* reached: the intervals have come to the last time */
    int due;                   /* a contact has ended, whose line comes next */
} certified;

void certified_clear(certified *c);
/** Begin with the intervals of a row with this word; 0 without memory. */
int certified_begin(certified *c, field word);
/**
 * Check the line of the next interval or contact: its form, and that the intervals spell the word.
 * graze-check verifies their claims.
 * @return NULL, or what is expected; `ended` is set behind the row's last line
 */
const char *certified_line(certified *c, const row_form *form, field line);

#endif
