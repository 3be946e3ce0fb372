/* Files whose bytes the library holds, put into it by the assembler.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_ASSET_H
#define GRAZE_REPORT_ASSET_H

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

#endif
