/* Opens what the commands read themselves.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_SOURCE_H
#define GRAZE_RUN_SOURCE_H

#include <stddef.h>

/** Open a file, or a pipe, whose writer is not waited for: the wait is that for its bytes
 * (interrupt.h). *fd is -1 on failure. Says what is wrong: EXIT_IO it cannot be opened, or is a
 * directory or a device, also behind a link. */
int source_open(int *fd, const char *path);

/** Open standard input instead. */
int source_standard(int *fd);

/** Read all that there is into a text of `room` bytes with a NUL, and no more than that. Says what
 * is wrong; EXIT_SIGNAL. */
int source_read(char *text, size_t room, size_t *length, const char *path);

#endif
