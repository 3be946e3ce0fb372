/* Finds the name that a misspelt word probably means.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTEXT_SPELLING_H
#define GRAZE_CONTEXT_SPELLING_H

#include <stddef.h>

/** The least number of steps from `a` to `b`. A step inserts, deletes or changes a letter or
 * exchanges two neighbours. It is 0 if `a` is another program's word for `b`, as angle for degrees,
 * and 31 if a word has more than 31 letters. */
int near_distance(const char *a, const char *b);

/** Set *best to `name` if it is at most two steps from `word`, at most one step for each three
 * letters of `name`, and nearer to `word` than *best. *best is NULL at first. */
void near_take(const char **best, const char *word, const char *name);

/** The nearest of some names to a word of `length` bytes, the first of equally near ones; NULL if
 * near_take would take none. */
const char *near_among(const char *word, size_t length, const char *const *names, size_t count);

#endif
