/* The rows of a shard.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/points/points.h"

#include <ctype.h>
#include <stdlib.h>

/* A number from 1 to SHARDS_MOST and the byte after it; NULL if there is none. */
static const char *read_shard_number(unsigned long *out, const char *text) {
    char *end;
    if (!isdigit((unsigned char)*text))
        return NULL;
    *out = strtoul(text, &end, 10);
    return *out >= 1 && *out <= SHARDS_MOST ? end : NULL;
}

int shard_read(shard *out, const char *text) {
    const char *at = read_shard_number(&out->index, text);
    if (!at || *at != '/')
        return 0;
    at = read_shard_number(&out->count, at + 1);
    if (!at || *at || out->index > out->count)
        return 0;
    out->index--;
    return 1;
}

unsigned long shard_place(shard s, unsigned long row) {
    return row * s.count + s.index;
}

unsigned long shard_rows(shard s, unsigned long rows) {
    return rows / s.count + (rows % s.count > s.index);
}
