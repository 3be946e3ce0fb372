/* Text that grows, for reports, comparisons and pictures.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_NUMBER_TEXT_H
#define GRAZE_NUMBER_TEXT_H

#include <flint/fmpq.h>
#include <flint/fmpz_poly.h>
#include "base/context/context.h"

/** A NUL-terminated text. Once memory has run short `failed` is set and nothing more is added. */
typedef struct text {
    char *data;
    size_t length, capacity;
    int failed;
} text;

void text_init(text *t);
void text_clear(text *t);
/** Room for `length` more bytes and a NUL, which the caller writes; 0 without memory. */
int text_reserve(text *t, size_t length);
void text_bytes(text *t, const char *bytes, size_t length);
void text_put(text *t, const char *string);
void text_format(text *t, const char *format, ...) __attribute__((format(printf, 2, 3)));
/** Append a count in decimal digits. */
void text_count(text *t, unsigned long value);
/** An integer. */
void text_integer(text *t, const fmpz_t value);
/** Append the coefficients of a polynomial, the constant one first, with blanks between them. */
void text_coefficients(text *t, const fmpz_poly_t p);
/** Append an integer or a ratio in lowest terms. */
void text_rational(text *t, const fmpq_t value);
/** Append a user's text so that Markdown shows it as it is, in a cell of a table too: characters
 * with a meaning in Markdown or HTML are escaped, line breaks and other control bytes become
 * blanks. */
void text_markdown(text *t, const char *string);
/** Append a user's text as code within a line of Markdown; control bytes become blanks. */
void text_code(text *t, const char *string);
/** Append a malloc'ed string and free it; NULL, the result of a failed allocation, sets `failed`.
 */
void text_owned(text *t, char *string);
/** Hand the text over as a malloc'ed string and clear; NULL when memory ran short. */
char *text_take(text *t);
/** Hand the text over as a malloc'ed string and clear; GRAZE_ESYSTEM when memory ran short. */
graze_status text_finish(char **out, graze_context *context, text *t);

#define ASSET __attribute__((visibility("hidden")))

/** Define a text that ends in NUL: the content of a file, given by its path from the repository's
 * root. */
#define ASSET_FILE(name, path)                                                                     \
    __asm__(".section .rodata\n"                                                                   \
            ".globl " #name "\n"                                                                   \
            ".hidden " #name "\n"                                                                  \
            ".type " #name ", %object\n" #name ":\n"                                               \
            ".incbin \"" path "\"\n"                                                               \
            ".byte 0\n"                                                                            \
            ".size " #name ", . - " #name "\n"                                                     \
            ".previous\n")

#endif
