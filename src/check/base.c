/* Ends, memory, words, number tokens.
 * SPDX-License-Identifier: MIT
 */
#include "base.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static _Noreturn void end(int status, const char *verdict, const char *format, va_list arguments) {
    fflush(stdout);
    fprintf(stderr, "graze-check: %s: ", verdict);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    exit(status);
}

void refute(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    end(REFUTED, "refuted", format, arguments);
    // cppcheck-suppress va_end_missing
}

void give_up(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    end(NOT_CHECKED, "not checked", format, arguments);
    // cppcheck-suppress va_end_missing
}

void *grow(void *old, size_t count, size_t size) {
    void *out = count <= SIZE_MAX / 2 / size ? realloc(old, count ? count * size : 1) : NULL;
    if (!out)
        give_up("out of memory for %zu items of %zu bytes", count, size);
    return out;
}

void *room_for(void *items, size_t count, size_t *room, size_t size) {
    if (count < *room)
        return items;
    *room = 2 * count + 8;
    return grow(items, *room, size);
}

char *read_file(size_t *length, const char *path) {
    FILE *file = fopen(path, "rb");
    if (!file)
        give_up("%s: cannot be opened", path);
    char *text = NULL;
    size_t room = 0, used = 0, more;
    do {
        room = 2 * room + 65536;
        text = grow(text, room, 1);
        more = fread(text + used, 1, room - used - 1, file);
        used += more;
    } while (used == room - 1);
    if (ferror(file))
        give_up("%s: cannot be read", path);
    fclose(file);
    text[used] = '\0';
    *length = used;
    return text;
}

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

static size_t digits(word *w) {
    size_t n = 0;
    while (n < w->length && w->at[n] >= '0' && w->at[n] <= '9')
        n++;
    return n;
}

static void skip(word *w, size_t n) {
    w->at += n;
    w->length -= n;
}

static int take(word *w, const char *any) {
    if (w->length == 0 || !*w->at || !strchr(any, *w->at))
        return 0;
    skip(w, 1);
    return 1;
}

/* The value of n digits is appended to out. */
static void append_digits(mpz_t out, const char *at, size_t n) {
    if (n == 0)
        return;
    char *copy = grow(NULL, n + 1, 1);
    memcpy(copy, at, n);
    copy[n] = '\0';
    mpz_t value, power;
    mpz_init_set_str(value, copy, 10);
    mpz_init(power);
    mpz_ui_pow_ui(power, 10, n);
    mpz_mul(out, out, power);
    mpz_add(out, out, value);
    mpz_clears(value, power, NULL);
    free(copy);
}

/* What follows the digits of a decimal: 0 if it is no exponent. */
static int read_exponent(long *out, word *w) {
    *out = 0;
    if (!take(w, "eE"))
        return 1;
    int negative = w->length > 0 && *w->at == '-';
    (void)take(w, "+-");
    size_t n = digits(w);
    if (n == 0)
        return 0;
    for (size_t k = 0; k < n; k++)
        *out = *out > MOST_DIGITS ? *out : 10 * *out + (w->at[k] - '0');
    skip(w, n);
    *out = negative ? -*out : *out;
    return 1;
}

static void scale_by_ten(mpq_t out, long exponent) {
    if (labs(exponent) > MOST_DIGITS)
        give_up("a number's exponent is past %d", MOST_DIGITS);
    mpz_t power;
    mpz_init(power);
    mpz_ui_pow_ui(power, 10, (unsigned long)labs(exponent));
    if (exponent >= 0)
        mpz_mul(mpq_numref(out), mpq_numref(out), power);
    else
        mpz_mul(mpq_denref(out), mpq_denref(out), power);
    mpz_clear(power);
}

static int read_ratio(mpq_t out, word *w) {
    size_t n = digits(w);
    mpz_set_ui(mpq_denref(out), 0);
    append_digits(mpq_denref(out), w->at, n);
    skip(w, n);
    if (n > 0 && mpz_sgn(mpq_denref(out)) != 0)
        return 1;
    mpz_set_ui(mpq_denref(out), 1);
    return 0;
}

int number_read(mpq_t out, word w) {
    if (w.length > MOST_DIGITS)
        give_up("'%.*s...' has more than %d digits", WORD(w), MOST_DIGITS);
    mpq_set_ui(out, 0, 1);
    int negative = w.length > 0 && *w.at == '-';
    (void)take(&w, "+-");
    size_t whole = digits(&w), part = 0;
    long exponent = 0;
    append_digits(mpq_numref(out), w.at, whole);
    skip(&w, whole);
    if (whole > 0 && take(&w, "/")) {
        if (!read_ratio(out, &w))
            return 0;
    } else {
        if (take(&w, ".")) {
            part = digits(&w);
            append_digits(mpq_numref(out), w.at, part);
            skip(&w, part);
        }
        if (whole + part == 0 || !read_exponent(&exponent, &w))
            return 0;
        scale_by_ten(out, exponent - (long)part);
    }
    if (w.length > 0)
        return 0;
    mpq_canonicalize(out);
    if (negative)
        mpq_neg(out, out);
    return 1;
}

int integer_read(mpz_t out, word w) {
    if (w.length > MOST_DIGITS)
        give_up("'%.*s...' has more than %d digits", WORD(w), MOST_DIGITS);
    int negative = w.length > 0 && *w.at == '-';
    if (negative)
        skip(&w, 1);
    if (w.length == 0 || digits(&w) != w.length)
        return 0;
    mpz_set_ui(out, 0);
    append_digits(out, w.at, w.length);
    if (negative)
        mpz_neg(out, out);
    return 1;
}

int count_read(size_t *out, word w) {
    *out = 0;
    if (w.length == 0 || w.length > 9 || digits(&w) != w.length)
        return 0;
    for (size_t k = 0; k < w.length; k++)
        *out = 10 * *out + (size_t)(w.at[k] - '0');
    return 1;
}
