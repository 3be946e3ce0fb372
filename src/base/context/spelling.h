/* The name that was probably meant.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTEXT_SPELLING_H
#define GRAZE_CONTEXT_SPELLING_H

#include <stddef.h>

/** Letters to insert, leave out, change or exchange with the next one that make a word of another,
 * or 0 for another word of the same meaning, as angle for degrees; words of more than 31 letters
 * are far from all. */
int near_distance(const char *a, const char *b);

/** Take a name as *best if it is nearer to the word than the best one so far, and near: at most two
 * steps, one in three letters. *best is NULL at first. */
void near_take(const char **best, const char *word, const char *name);

/** The nearest of some names to a word of `length` bytes, of equally near ones the first; NULL
 * where none is near. */
const char *near_among(const char *word, size_t length, const char *const *names, size_t count);

#endif
