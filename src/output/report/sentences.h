/* The sentences of explanations, for texts and for pages: sentences.json, a line for each key.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_SENTENCES_H
#define GRAZE_REPORT_SENTENCES_H

#include "base/number/text.h"

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

/** The content of sentences.json. */
extern const char sentences[] ASSET;

/** Append the sentence of a key. The arguments replace its marks in order: a text for %, an
 * unsigned long for #, a rational for @, a point or a vector with its dimension for ~ or &, a key
 * for $, whose sentence is inserted and takes the arguments after it.
 */
void sentence_put(text *out, const char *key, ...);

#endif
