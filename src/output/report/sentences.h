/* The sentences of explanations, for texts and for pages: sentences.json, a line for each key.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_SENTENCES_H
#define GRAZE_REPORT_SENTENCES_H

#include "base/number/text.h"

#define ASSET __attribute__((visibility("hidden")))

/** Define a text that is ended by a NUL: a file by its path from the repository's root. */
#define ASSET_FILE(name, path)                                                                     \
    __asm__(".section .rodata\n"                                                                   \
            ".globl " #name "\n"                                                                   \
            ".hidden " #name "\n"                                                                  \
            ".type " #name ", %object\n" #name ":\n"                                               \
            ".incbin \"" path "\"\n"                                                               \
            ".byte 0\n"                                                                            \
            ".size " #name ", . - " #name "\n"                                                     \
            ".previous\n")

/** That file. */
extern const char sentences[] ASSET;

/** Add a sentence, each % filled by a text, # by an unsigned long, @ by a rational, ~ by a point
 * and & by a vector with their dimensions, $ by the sentence of a key, whose own fillings follow.
 */
void sentence_put(text *out, const char *key, ...);

#endif
