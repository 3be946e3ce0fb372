/* SHA-256 (FIPS 180-4).
 * SPDX-License-Identifier: MIT
 */
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include "base.h"

/* The first 32 bits behind the point of the square roots of the first 8 primes and of the cube
 * roots of the first 64, made exactly. */
static uint32_t root_bits(unsigned long prime, unsigned long degree) {
    mpz_t x;
    mpz_init_set_ui(x, prime);
    mpz_mul_2exp(x, x, 32 * degree);
    mpz_root(x, x, degree);
    uint32_t out = (uint32_t)mpz_get_ui(x);
    mpz_clear(x);
    return out;
}

static uint32_t turn(uint32_t x, int n) {
    return x >> n | x << (32 - n);
}

static void constants(uint32_t state[8], uint32_t k[64]) {
    int n = 0;
    for (unsigned long p = 2; n < 64; p++) {
        int prime = 1;
        for (unsigned long q = 2; q * q <= p; q++)
            prime = prime && p % q != 0;
        if (!prime)
            continue;
        if (n < 8)
            state[n] = root_bits(p, 2);
        k[n++] = root_bits(p, 3);
    }
}

static void block(uint32_t state[8], const uint32_t k[64], const unsigned char *bytes) {
    uint32_t w[64], s[8];
    for (int i = 0; i < 16; i++)
        w[i] = (uint32_t)bytes[4 * i] << 24 | (uint32_t)bytes[4 * i + 1] << 16 |
               (uint32_t)bytes[4 * i + 2] << 8 | bytes[4 * i + 3];
    for (int i = 16; i < 64; i++)
        w[i] = w[i - 16] + w[i - 7] + (turn(w[i - 15], 7) ^ turn(w[i - 15], 18) ^ w[i - 15] >> 3) +
               (turn(w[i - 2], 17) ^ turn(w[i - 2], 19) ^ w[i - 2] >> 10);
    memcpy(s, state, sizeof s);
    for (int i = 0; i < 64; i++) {
        uint32_t choice = (s[4] & s[5]) ^ (~s[4] & s[6]);
        uint32_t majority = (s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]);
        uint32_t first =
            s[7] + (turn(s[4], 6) ^ turn(s[4], 11) ^ turn(s[4], 25)) + choice + k[i] + w[i];
        uint32_t second = (turn(s[0], 2) ^ turn(s[0], 13) ^ turn(s[0], 22)) + majority;
        memmove(s + 1, s, 7 * sizeof *s);
        s[4] += first;
        s[0] = first + second;
    }
    for (int i = 0; i < 8; i++)
        state[i] += s[i];
}

void sha256_text(char out[65], const char *bytes, size_t length) {
    uint32_t state[8], k[64];
    unsigned char last[128] = {0};
    size_t whole = length / 64 * 64, rest = length - whole, size = rest < 56 ? 64 : 128;
    constants(state, k);
    for (size_t i = 0; i < whole; i += 64)
        block(state, k, (const unsigned char *)bytes + i);
    memcpy(last, bytes + whole, rest);
    last[rest] = 0x80;
    for (size_t i = 0; i < 8; i++)
        last[size - 1 - i] = (unsigned char)((uint64_t)length * 8 >> 8 * i);
    for (size_t i = 0; i < size; i += 64)
        block(state, k, last + i);
    for (int i = 0; i < 8; i++)
        sprintf(out + 8 * i, "%08x", state[i]);
}
