/* Files that a command reads and writes, compared before it opens one for writing.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Two names are one file where device and inode are the same; of a file that is not there yet,
 * where the folder is the same and the name in it. Pipes, devices and folders are left alone.
 */
#ifndef GRAZE_RUN_GUARD_H
#define GRAZE_RUN_GUARD_H

#include <stddef.h>

/** How a file is used; GUARD_INPUT: read, where `-` is standard input. */
typedef enum guard_use { GUARD_READ, GUARD_INPUT, GUARD_WRITTEN } guard_use;

/** Zeroed, and guard_clear. Strings are borrowed. */
typedef struct guard {
    struct guarded *item;
    size_t count, room;
    int failed; /* memory ran out */
} guard;

/**
 * Add a file.
 * @param option the option that names it, without `--`; NULL: an operand
 * @param path   its name; NULL, or of a file to write `-`: standard output
 * @param ending stands behind the path, "" for none
 */
void guard_add(guard *g, guard_use use, const char *option, const char *path, const char *ending);

/** Refuse a file that is written and named a second time: EXIT_USAGE, and says so; EXIT_IO. */
int guard_check(const guard *g);

void guard_clear(guard *g);

#endif
