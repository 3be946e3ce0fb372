/* A sink of bytes: a text in memory, or a file.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TABLE_SINK_H
#define GRAZE_TABLE_SINK_H

#include <stddef.h>

/** `to` keeps its failures. */
typedef struct sink {
    void (*put)(void *to, const char *bytes, size_t length);
    void *to;
} sink;

#endif
