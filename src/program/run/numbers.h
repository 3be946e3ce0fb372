/* Numbers on the command line, and as text.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_NUMBERS_H
#define GRAZE_RUN_NUMBERS_H

#include "graze.h"

/**
 * Read `count` numbers between commas.
 * @param[out] out     initialised rationals
 * @param name         the option, for the message
 * @return EXIT_USAGE, EXIT_LIMIT
 */
int numbers_read(mpq_t *out, graze_context *context, const char *name, const char *text,
                 size_t length, int count);

/** A whole number from `low` up; digits only. 1 if it is one. */
int numbers_count(unsigned long *out, const char *text, unsigned long low);

/** An integer, or a ratio in lowest terms: malloc'ed; NULL when out of memory. */
char *numbers_text(const mpq_t value);

#endif
