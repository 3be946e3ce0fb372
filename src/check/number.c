/* Words and number tokens.
 * SPDX-License-Identifier: MIT
 */
#include "base.h"

#include <stdlib.h>
#include <string.h>

word word_of(const char *text) {
    return (word){text, strlen(text)};
}

int word_is(word w, const char *text) {
    return w.length == strlen(text) && memcmp(w.at, text, w.length) == 0;
}

/* Remove the first n bytes of w and return them. */
static word take(word *w, size_t n) {
    word out = {w->at, n};
    *w = (word){w->at + n, w->length - n};
    return out;
}

static int is_in(char c, const char *set) {
    return c != '\0' && strchr(set, c) != NULL;
}

int word_take(word *w, const char *any) {
    return take(w, w->length > 0 && is_in(*w->at, any)).length > 0;
}

word word_cut(word *w, const char *stops) {
    size_t n = 0;
    while (n < w->length && !is_in(w->at[n], stops))
        n++;
    return take(w, n);
}

word word_digits(word *w) {
    size_t n = 0;
    while (n < w->length && is_in(w->at[n], "0123456789"))
        n++;
    return take(w, n);
}

/* Read the number whose digits are those of a followed by those of b. */
static void read_digits(mpz_t out, word a, word b) {
    if (a.length + b.length > MOST_DIGITS)
        give_up("'%.*s...' has more than %d digits", WORD(a), MOST_DIGITS);
    char *text = grow(NULL, a.length + b.length + 1, 1);
    memcpy(text, a.at, a.length);
    memcpy(text + a.length, b.at, b.length);
    text[a.length + b.length] = '\0';
    mpz_set_str(out, text, 10);
    free(text);
}

/* Remove a sign from w; returns 1 if it is a minus. */
static int take_sign(word *w) {
    int minus = word_take(w, "-");
    if (!minus)
        (void)word_take(w, "+");
    return minus;
}

/* Read an exponent if one follows, else set 0; a value far beyond MOST_DIGITS is not computed in
 * full. Returns 0 if an `e` is not followed by digits. */
static int read_exponent(long *out, word *w) {
    *out = 0;
    if (!word_take(w, "eE"))
        return 1;
    int minus = take_sign(w);
    word digits = word_digits(w);
    for (size_t k = 0; k < digits.length && *out <= MOST_DIGITS; k++)
        *out = 10 * *out + (digits.at[k] - '0');
    *out = minus ? -*out : *out;
    return digits.length > 0;
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

/* Read a number without its sign; `out` is not yet canonical. Returns 0 if w is none. */
static int read_positive(mpq_t out, word w) {
    word whole = word_digits(&w), part = {w.at, 0};
    long exponent;
    if (whole.length > 0 && word_take(&w, "/")) {
        word below = word_digits(&w);
        if (below.length == 0 || w.length > 0)
            return 0;
        read_digits(mpq_numref(out), whole, part);
        read_digits(mpq_denref(out), below, part);
        return mpz_sgn(mpq_denref(out)) != 0;
    }
    if (word_take(&w, "."))
        part = word_digits(&w);
    if (whole.length + part.length == 0 || !read_exponent(&exponent, &w) || w.length > 0)
        return 0;
    read_digits(mpq_numref(out), whole, part);
    scale_by_ten(out, exponent - (long)part.length);
    return 1;
}

int number_read(mpq_t out, word w) {
    int minus = take_sign(&w);
    mpq_set_ui(out, 0, 1);
    if (!read_positive(out, w))
        return 0;
    mpq_canonicalize(out);
    if (minus)
        mpq_neg(out, out);
    return 1;
}

int integer_read(mpz_t out, word w) {
    int minus = word_take(&w, "-");
    word digits = word_digits(&w);
    if (digits.length == 0 || w.length > 0)
        return 0;
    read_digits(out, digits, w);
    if (minus)
        mpz_neg(out, out);
    return 1;
}

int count_read(size_t *out, word w) {
    word digits = word_digits(&w);
    *out = 0;
    for (size_t k = 0; k < digits.length && k < 9; k++)
        *out = 10 * *out + (size_t)(digits.at[k] - '0');
    return digits.length > 0 && digits.length <= 9 && w.length == 0;
}
