/* Arrays, words, number tokens, files and their tokens.
 * SPDX-License-Identifier: MIT
 */
#include "base.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void *room_for(void *items, size_t count, size_t *room, size_t size) {
    if (count < *room)
        return items;
    *room = 2 * count + 8;
    return grow(items, *room, size);
}

mpz_t *integers(size_t count) {
    mpz_t *out = grow(NULL, count, sizeof *out);
    for (size_t k = 0; k < count; k++)
        mpz_init(out[k]);
    return out;
}

void integers_free(mpz_t *x, size_t count) {
    for (size_t k = 0; k < count; k++)
        mpz_clear(x[k]);
    free(x);
}

/* --------------------------------------------------------------------------------------- words */

int word_is(word w, const char *text) {
    return w.length == strlen(text) && memcmp(w.at, text, w.length) == 0;
}

int word_next(word *out, const char **at, const char *end) {
    while (*at < end && (**at == ' ' || **at == '\t'))
        ++*at;
    out->at = *at;
    while (*at < end && **at != ' ' && **at != '\t')
        ++*at;
    out->length = (size_t)(*at - out->at);
    return out->length > 0;
}

size_t word_digits(word w) {
    size_t n = 0;
    while (n < w.length && w.at[n] >= '0' && w.at[n] <= '9')
        n++;
    return n;
}

void word_skip(word *w, size_t n) {
    w->at += n;
    w->length -= n;
}

int word_take(word *w, const char *any) {
    if (w->length == 0 || !*w->at || !strchr(any, *w->at))
        return 0;
    word_skip(w, 1);
    return 1;
}

/* ------------------------------------------------------------------------------------- numbers */

/* Move the digits at the beginning of w behind the text that ends at *end; how many. */
static size_t take_digits(char **end, word *w) {
    size_t n = word_digits(*w);
    memcpy(*end, w->at, n);
    *end += n;
    **end = '\0';
    word_skip(w, n);
    return n;
}

/* An exponent may follow: its value, at most one past MOST_DIGITS; 0 if it is none. */
static int read_exponent(long *out, word *w) {
    *out = 0;
    if (!word_take(w, "eE"))
        return 1;
    int negative = word_take(w, "-");
    if (!negative)
        (void)word_take(w, "+");
    size_t n = word_digits(*w);
    for (size_t k = 0; k < n && *out <= MOST_DIGITS; k++)
        *out = 10 * *out + (w->at[k] - '0');
    word_skip(w, n);
    *out = negative ? -*out : *out;
    return n > 0;
}

static void scale_by_ten(mpq_t out, long exponent) {
    if (labs(exponent) > MOST_DIGITS)
        give_up("a number's exponent is past %d", MOST_DIGITS);
    mpz_t power;
    mpz_init(power);
    mpz_ui_pow_ui(power, 10, (unsigned long)labs(exponent));
    mpz_ptr part = exponent >= 0 ? mpq_numref(out) : mpq_denref(out);
    mpz_mul(part, part, power);
    mpz_clear(power);
}

/* Without its sign. `text` has room for all digits. */
static int read_positive(mpq_t out, word w, char *text) {
    char *end = text;
    size_t whole = take_digits(&end, &w), part = 0;
    long exponent;
    if (whole > 0 && word_take(&w, "/")) {
        mpz_set_str(mpq_numref(out), text, 10);
        end = text;
        if (take_digits(&end, &w) == 0 || w.length > 0)
            return 0;
        mpz_set_str(mpq_denref(out), text, 10);
        return mpz_sgn(mpq_denref(out)) != 0;
    }
    if (word_take(&w, "."))
        part = take_digits(&end, &w);
    if (whole + part == 0 || !read_exponent(&exponent, &w) || w.length > 0)
        return 0;
    mpz_set_str(mpq_numref(out), text, 10);
    scale_by_ten(out, exponent - (long)part);
    return 1;
}

int number_read(mpq_t out, word w) {
    if (w.length > MOST_DIGITS)
        give_up("'%.*s...' has more than %d digits", WORD(w), MOST_DIGITS);
    char *text = grow(NULL, w.length + 1, 1);
    int negative = word_take(&w, "-");
    if (!negative)
        (void)word_take(&w, "+");
    mpq_set_ui(out, 0, 1);
    int good = read_positive(out, w, text);
    free(text);
    if (!good)
        return 0;
    mpq_canonicalize(out);
    if (negative)
        mpq_neg(out, out);
    return 1;
}

int integer_read(mpz_t out, word w) {
    mpq_t value;
    word digits = w;
    (void)word_take(&digits, "-");
    if (digits.length == 0 || word_digits(digits) != digits.length)
        return 0;
    mpq_init(value);
    int good = number_read(value, w);
    mpz_set(out, mpq_numref(value));
    mpq_clear(value);
    return good;
}

int count_read(size_t *out, word w) {
    *out = 0;
    if (w.length == 0 || w.length > 9 || word_digits(w) != w.length)
        return 0;
    for (size_t k = 0; k < w.length; k++)
        *out = 10 * *out + (size_t)(w.at[k] - '0');
    return 1;
}

/* --------------------------------------------------------------------------------------- files */

static FILE *opened(const char *path) {
    FILE *file = fopen(path, "rb");
    if (!file)
        give_up("%s: cannot be opened", path);
    return file;
}

char *read_file(size_t *length, const char *path) {
    FILE *file = opened(path);
    char *text = NULL;
    size_t room = 0, used = 0;
    do {
        room = 2 * room + 65536;
        text = grow(text, room, 1);
        used += fread(text + used, 1, room - used - 1, file);
    } while (used == room - 1);
    if (ferror(file))
        give_up("%s: cannot be read", path);
    fclose(file);
    text[used] = '\0';
    *length = used;
    return text;
}

source source_open(const char *path, const char *text, size_t length) {
    size_t mark = length >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    return (source){path, text + mark, text + length, 1, 0, 0};
}

void source_fail(const source *f, const char *what) {
    give_up("%s:%zu: %s", f->path, f->line, what);
}

/* Pass over blanks and comments. */
static void skip_blanks(source *f) {
    int comment = 0;
    f->first = 0;
    for (; f->at < f->end; f->at++) {
        comment = (comment || (f->comments && *f->at == '#')) && *f->at != '\n';
        if (!comment && *f->at != ' ' && *f->at != '\t' && *f->at != '\r' && *f->at != '\n')
            return;
        f->first = f->first || *f->at == '\n';
        f->line += *f->at == '\n';
    }
}

static int is_in(char c, const char *set) {
    return c != '\0' && strchr(set, c) != NULL;
}

word token(source *f, const char *marks) {
    skip_blanks(f);
    word out = {f->at, 0};
    size_t rest = (size_t)(f->end - f->at);
    if (rest > 0 && is_in(*f->at, marks)) {
        out.length = 1;
    } else if (rest > 0 && *f->at == '"') {
        for (out.length = 1; out.length < rest && out.at[out.length] != '"'; out.length++)
            if (out.at[out.length] == '\\' || (unsigned char)out.at[out.length] < ' ')
                source_fail(f, "a backslash or control character in a string");
        if (out.length++ == rest)
            source_fail(f, "a string has no end");
    } else {
        while (out.length < rest && !is_in(out.at[out.length], marks) &&
               !is_in(out.at[out.length], " \t\r\n"))
            out.length++;
    }
    f->at += out.length;
    return out;
}

void token_want(source *f, const char *marks, const char *expected) {
    word w = token(f, marks);
    if (!word_is(w, expected))
        give_up("%s:%zu: '%.*s'; expected %s", f->path, f->line, WORD(w), expected);
}

int token_goes_on(source *f, const char *marks, const char *close) {
    word w = token(f, marks);
    if (word_is(w, ","))
        return 1;
    if (!word_is(w, close))
        give_up("%s:%zu: '%.*s'; expected ',' or %s", f->path, f->line, WORD(w), close);
    return 0;
}
