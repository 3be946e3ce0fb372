/* Checksums of 64 bits. SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/io/io.h"

static unsigned long long mixed(unsigned long long sum, unsigned long long word) {
    sum = (sum ^ word) * 0x9e3779b97f4a7c15ULL;
    return sum ^ sum >> 32;
}

/* 8 bytes as a number, the first byte lowest on every machine. */
static unsigned long long word_of(const unsigned char *at) {
    unsigned long long word = 0;
    for (int k = 0; k < 8; k++)
        word |= (unsigned long long)at[k] << 8 * k;
    return word;
}

static void add_byte(checksum *c, unsigned char byte) {
    c->held |= (unsigned long long)byte << 8 * (c->length % 8);
    if (++c->length % 8 == 0) {
        c->sum = mixed(c->sum, c->held);
        c->held = 0;
    }
}

void checksum_add(checksum *c, const char *bytes, size_t length) {
    const unsigned char *at = (const unsigned char *)bytes, *end = at + length;
    while (at < end && c->length % 8)
        add_byte(c, *at++);
    for (; end - at >= 8; at += 8, c->length += 8)
        c->sum = mixed(c->sum, word_of(at));
    while (at < end)
        add_byte(c, *at++);
}

unsigned long long checksum_value(const checksum *c) {
    return mixed(mixed(c->sum, c->held), c->length);
}
