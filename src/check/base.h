/* What every part of graze-check uses: how it ends, memory, words, numbers, SHA-256.
 * SPDX-License-Identifier: MIT
 *
 * graze-check ends at the first thing that is wrong: status 1, refuted; status 2, could not check.
 * There is no other way past a test that has not succeeded.
 */
#ifndef CHECK_BASE_H
#define CHECK_BASE_H

#include <gmp.h>
#include <stddef.h>

enum { VERIFIED = 0, REFUTED = 1, NOT_CHECKED = 2 };

/** Caps. Past one of them the status is 2. */
enum {
    MOST_DIGITS = 20000,  /* of one number token, its exponent written out */
    MOST_DEGREE = 300,    /* of a polynomial */
    MOST_BITS = 1 << 20,  /* of a coefficient of the motion */
    MOST_PIECES = 100000, /* of the motion */
    MOST_DEPTH = 200,     /* of brackets */
    MOST_LINE = 1 << 26,  /* bytes of a line of a certificate or a table */
    MOST_WORD = 100000,   /* letters of a word */
    MOST_CORNERS = 500    /* vertices of one facet */
};

/** Write `graze-check: refuted: MESSAGE`, exit with status 1. */
_Noreturn void refute(const char *format, ...) __attribute__((format(printf, 1, 2)));
/** Write `graze-check: not checked: MESSAGE`, exit with status 2. */
_Noreturn void give_up(const char *format, ...) __attribute__((format(printf, 1, 2)));

/** As realloc, for count items; gives up without memory. */
void *grow(void *old, size_t count, size_t size);
/** Make room for one more item than `count`, doubling. */
void *room_for(void *items, size_t count, size_t *room, size_t size);

/** A file's bytes, with a NUL behind them. Gives up if it cannot be read. */
char *read_file(size_t *length, const char *path);

/** A piece of text. */
typedef struct word {
    const char *at;
    size_t length;
} word;

int word_is(word w, const char *text);
/** The next word of [*at, end), parted by blanks and tabs; 0 if there is none. */
int word_next(word *out, const char **at, const char *end);
/** For messages: "%.*s", WORD(w) */
#define WORD(w) (int)((w).length < 60 ? (w).length : 60), (w).at

/** Read a whole number token: `-12`, `0.1`, `1.5e-3`, `22/7`; 1, or 0 if it is none. Gives up past
 * the digits. */
int number_read(mpq_t out, word w);
/** Read a whole integer token. */
int integer_read(mpz_t out, word w);
/** Read a count written in at most nine decimal digits. */
int count_read(size_t *out, word w);

/** SHA-256 of bytes as 64 hexadecimal digits and a NUL. */
void sha256_text(char out[65], const char *bytes, size_t length);

#endif
