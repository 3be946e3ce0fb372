/* The type of the readers of solids; read.c chooses one by the file's extension.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Each takes a whole file's bytes and fills an initialised soup of the format's dimension. What it
 * leaves in the soup on failure is the caller's to clear. A message names path and line, or path
 * and byte in a binary file.
 */
#ifndef GRAZE_READ_READER_H
#define GRAZE_READ_READER_H

#include "input/soup/soup.h"

typedef graze_status soup_reader(soup *s, graze_context *context, const char *path,
                                 const char *text, size_t length);

#endif
