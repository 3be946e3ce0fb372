/* Checksums of 64 bits over bytes, against accidents.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_CHECKSUM_H
#define GRAZE_RUN_CHECKSUM_H

#include <stddef.h>

/** Zeroed: of no bytes. How the bytes are cut into calls does not matter. */
typedef struct checksum {
    unsigned long long sum, held; /* held: the last length % 8 bytes, the first one lowest */
    unsigned long long length;
} checksum;

void checksum_add(checksum *c, const char *bytes, size_t length);
/** The value for the bytes so far. */
unsigned long long checksum_value(const checksum *c);

#endif
