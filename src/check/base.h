/* Common tools of graze-check: arrays, work, words, numbers, files, SHA-256.
 * SPDX-License-Identifier: MIT
 */
#ifndef CHECK_BASE_H
#define CHECK_BASE_H

#include <gmp.h>
#include <stddef.h>
#include <stdio.h>
#include "ends.h"

/** Caps. Past one of them the status is 2. */
enum {
    MOST_DIGITS = 20000, /* of one number token, its exponent written out */
    MOST_DEGREE = 300,   /* of a polynomial */
    MOST_BITS = 1 << 20, /* of a coefficient of the motion, of the solid's common denominator */
    MOST_LINE = 1 << 24, /* bytes of a line of a certificate or a table */
    MOST_WORD = 100000,  /* letters of a word */
    MOST_WORK = 1 << 30, /* in products of two words; work_on counts them */
    /* More of it for a step of a motion or a row, for one of a solid's facets, for a coordinate. */
    STEP_WORK = 1 << 23,
    SOLID_WORK = 1 << 20,
    NUMBER_WORK = 1 << 12
};

/** Begin to count work: MOST_WORK is left. */
void work_begin(void);
/** A step of proofs/certificate.md K14 follows: so much more is left, MOST_WORK at most. */
void work_allow(size_t more);
/** A product, a quotient or a common divisor of a and b follows; gives up if too little is left. */
void work_on(const mpz_t a, const mpz_t b);

/** Make room for one more item than `count`, doubling. */
void *room_for(void *items, size_t count, size_t *room, size_t size);
/** Integers that are zero, for integers_free. */
mpz_t *integers(size_t count);
void integers_free(mpz_t *x, size_t count);
/** x[k] = out[k] / out[count], the last positive and the least one. */
void integers_of(mpz_t *out, mpq_srcptr const *x, size_t count);

/** A piece of text. */
typedef struct word {
    const char *at;
    size_t length;
} word;

/** For messages: "%.*s", WORD(w) */
#define WORD(w) (int)((w).length < 60 ? (w).length : 60), (w).at
word word_of(const char *text);
int word_is(word w, const char *text);
/** Take off the beginning of w: one of these characters, if it stands there; what stands before the
 * first of them; the digits. */
int word_take(word *w, const char *any);
word word_cut(word *w, const char *stops);
word word_digits(word *w);

/** Read a whole number token: `-12`, `0.1`, `1.5e-3`, `22/7`; 1, or 0 if it is none. Gives up past
 * the digits. */
int number_read(mpq_t out, word w);
/** Read a whole integer token, a count in at most nine digits. */
int integer_read(mpz_t out, word w);
int count_read(size_t *out, word w);

/** A file read line by line. */
typedef struct lines {
    const char *path;
    FILE *file;
    char *text;
    size_t room, line;
} lines;

/** Gives up if it cannot be opened. */
lines lines_open(const char *path);
/** The next line without its end, valid until the next; 0 at the end of the file. */
int lines_next(lines *l, word *out);

/** A text being read: tokens. */
typedef struct source {
    const char *path, *at, *end;
    size_t line;
    const char *marks; /* what ends a token, blanks too; a mark that is no blank is one itself */
    int comments;      /* there are some, from # to the end of a line */
    int first;         /* the last token is the first of its line */
} source;

#define BLANKS " \t\r\n"

_Noreturn void source_fail(const source *f, const char *what);
/** Begin to read a file; refutes it if its SHA-256 is another. */
source source_open(const char *path, const char *sha256, const char *marks);
/** The next token: a mark, a text in quotes with them if they are marks, or what stands before the
 * next mark; blanks and comments are passed over. Empty at the end. */
word token(source *f);
/** The next tokens must be these, which blanks part. */
void token_want(source *f, const char *expected);
/** 1 after a comma, 0 after `close`. */
int token_goes_on(source *f, const char *close);

/** SHA-256 of bytes as 64 hexadecimal digits and a NUL. */
void sha256_text(char out[65], const char *bytes, size_t length);

#endif
