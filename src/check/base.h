/* Common tools of graze-check: arrays, work, words, numbers, files, SHA-256.
 * SPDX-License-Identifier: MIT
 */
#ifndef CHECK_BASE_H
#define CHECK_BASE_H

#include <gmp.h>
#include <stddef.h>
#include <stdio.h>
#include "ends.h"

/** Limits. graze-check gives up with status 2 where one of them is exceeded. */
enum {
    MOST_DIGITS = 20000, /* of one number token, its exponent written out */
    MOST_DEGREE = 300,   /* of a polynomial */
    MOST_BITS = 1 << 20, /* of a coefficient of the motion, of the solid's common denominator */
    MOST_LINE = 1 << 24, /* bytes of a line of a certificate or a table */
    MOST_WORD = 100000,  /* letters of a word */
    MOST_WORK = 1 << 30, /* in products of two machine words; work_on counts them */
    /* Work that is added by work_allow: for a step of a motion or a row, for a facet, for a
     * coordinate. */
    STEP_WORK = 1 << 23,
    SOLID_WORK = 1 << 20,
    NUMBER_WORK = 1 << 12
};

/** Begin to count work: MOST_WORK is left. */
void work_begin(void);
/** Add `more` to the work that is left, up to MOST_WORK, since a step of proofs/certificate.md K14
 * follows. */
void work_allow(size_t more);
/** Count the work of a product, quotient or common divisor of a and b, which follows; gives up if
 * too little is left. */
void work_on(const mpz_t a, const mpz_t b);

/** Return the array `items` with room for one more item than `count`. A full array is enlarged to
 * more than twice its size; *room is its size. */
void *room_for(void *items, size_t count, size_t *room, size_t size);
/** Allocate `count` integers, all zero; integers_free frees them. */
mpz_t *integers(size_t count);
void integers_free(mpz_t *x, size_t count);
/** Bring `count` rationals to their least common denominator out[count] > 0: x[k] = out[k] /
 * out[count]. */
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
/** Each removes the beginning of w. word_take removes one character if it is in `any`, and returns
 * 1, else 0. word_cut removes and returns all before the first character of `stops`, word_digits
 * the leading digits. */
int word_take(word *w, const char *any);
word word_cut(word *w, const char *stops);
word word_digits(word *w);

/** Read a whole number token: `-12`, `0.1`, `1.5e-3`, `22/7`; returns 1, or 0 if w is none. Gives
 * up on more than MOST_DIGITS digits. */
int number_read(mpq_t out, word w);
/** Read a whole token: integer_read an integer, count_read a count of at most nine digits. Returns
 * 1, or 0 if the token is none. */
int integer_read(mpz_t out, word w);
int count_read(size_t *out, word w);

/** A file read line by line. */
typedef struct lines {
    const char *path;
    FILE *file;
    char *text;
    size_t room, line;
} lines;

/** Open a file; gives up if that fails. */
lines lines_open(const char *path);
/** Set `out` to the next line without its newline, valid until the next call; returns 0 at the end
 * of the file. */
int lines_next(lines *l, word *out);

/** A text that is read token by token. */
typedef struct source {
    const char *path, *at, *end;
    size_t line;
    const char *marks; /* characters that end a token, blanks among them; a mark that is no blank is
                          a token itself */
    int comments;      /* 1 if the file has comments, from # to the end of the line */
    int first;         /* 1 if the last token was the first of its line */
} source;

#define BLANKS " \t\r\n"

_Noreturn void source_fail(const source *f, const char *what);
/** Read a file into memory; refutes it if it does not have this SHA-256. */
source source_open(const char *path, const char *sha256, const char *marks);
/** The next token: a mark; a text in quotes, quotes included, if these are marks; or all characters
 * before the next mark. Blanks and comments are skipped. Empty at the end. */
word token(source *f);
/** Read tokens and compare them with those of `expected`, separated by blanks; gives up if one
 * differs. */
void token_want(source *f, const char *expected);
/** Read one token: returns 1 if it is a comma, 0 if it is `close`; gives up else. */
int token_goes_on(source *f, const char *close);

/** SHA-256 of bytes as 64 hexadecimal digits and a NUL. */
void sha256_text(char out[65], const char *bytes, size_t length);

#endif
