/* Exact rationals as text: number tokens in, lowest terms out (src/program/cli/formats.md,
 * Numbers). SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A token is first read for its shape, the limit then acts on the counted digits, and only then is
 * a number made.
 */
#include <flint/ulong_extras.h>
#include <stdint.h>
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "base/number/rounding.h"

enum { EXPONENT_CAP = 2000000000, SHOWN = 40 };

/* The parts of a token, as pointers into its text. `exponent` is cut to +-EXPONENT_CAP, which
 * exceeds every limit. */
typedef struct shape {
    int negative;
    const char *whole, *fraction, *denominator; /* denominator NULL unless a ratio */
    size_t whole_count, fraction_count, denominator_count;
    long exponent;
} shape;

static size_t digit_run(const char *p, const char *end) {
    const char *start = p;
    while (p < end && *p >= '0' && *p <= '9')
        p++;
    return (size_t)(p - start);
}

static int is_sign_character(const char *p, const char *end) {
    return p < end && (*p == '+' || *p == '-');
}

/* Read the exponent behind its `e`. Returns the place behind it, or NULL if it has no digits. */
static const char *exponent_shape(long *exponent, const char *p, const char *end) {
    int negative = p < end && *p == '-';
    p += is_sign_character(p, end);
    size_t n = digit_run(p, end);
    long value = 0;
    for (size_t k = 0; k < n && value < EXPONENT_CAP; k++)
        value = 10 * value + (p[k] - '0');
    value = value > EXPONENT_CAP ? EXPONENT_CAP : value;
    *exponent = negative ? -value : value;
    return n == 0 ? NULL : p + n;
}

static int token_shape(shape *s, const char *p, size_t length) {
    const char *end = p + length;
    *s = (shape){.negative = p < end && *p == '-'};
    p += is_sign_character(p, end);
    s->whole = p;
    s->whole_count = digit_run(p, end);
    p += s->whole_count;
    if (p < end && *p == '/' && s->whole_count > 0) {
        s->denominator = p + 1;
        s->denominator_count = digit_run(p + 1, end);
        return s->denominator_count > 0 && p + 1 + s->denominator_count == end;
    }
    if (p < end && *p == '.') {
        s->fraction = p + 1;
        s->fraction_count = digit_run(p + 1, end);
        p += 1 + s->fraction_count;
    }
    if (s->whole_count + s->fraction_count == 0)
        return 0;
    if (p < end && (*p == 'e' || *p == 'E'))
        p = exponent_shape(&s->exponent, p + 1, end);
    return p == end;
}

int rational_is_token(const char *text, size_t length) {
    shape s;
    return token_shape(&s, text, length);
}

/* Digits of the decimal written without exponent: those before and those behind its point. */
static unsigned long written_out(const shape *s) {
    long before = (long)s->whole_count + s->exponent;
    long behind = (long)s->fraction_count - s->exponent;
    return (unsigned long)(before > 0 ? before : 0) + (unsigned long)(behind > 0 ? behind : 0);
}

/* Set `out` to the integer with two runs of digits, one after the other. Returns 0 if memory is
 * short. */
static int set_digits(fmpz_t out, const char *a, size_t a_count, const char *b, size_t b_count) {
    char *digits = malloc(a_count + b_count + 1);
    if (digits == NULL)
        return 0;
    memcpy(digits, a, a_count);
    if (b_count > 0)
        memcpy(digits + a_count, b, b_count);
    digits[a_count + b_count] = '\0';
    int failed = fmpz_set_str(out, digits, 10);
    free(digits);
    return !failed;
}

static int set_decimal(fmpq_t out, const shape *s) {
    if (!set_digits(fmpq_numref(out), s->whole, s->whole_count, s->fraction, s->fraction_count))
        return 0;
    long shift = s->exponent - (long)s->fraction_count;
    LOCAL(fmpz, power);
    fmpz_set_ui(power, 10);
    fmpz_pow_ui(power, power, (unsigned long)labs(shift));
    if (shift >= 0) {
        fmpz_mul(fmpq_numref(out), fmpq_numref(out), power);
        fmpz_one(fmpq_denref(out));
    } else {
        fmpz_set(fmpq_denref(out), power);
        fmpq_canonicalise(out);
    }
    return 1;
}

/* Append a run of digits to `value`; returns 0 if the number might not fit into 64 bits. */
static int append_digits(uint64_t *value, const char *digits, size_t count) {
    for (size_t k = 0; k < count; k++) {
        if (*value > (UINT64_MAX - 9) / 10)
            return 0;
        *value = 10 * *value + (uint64_t)(digits[k] - '0');
    }
    return 1;
}

/* Set `out` to value * 10^shift in lowest terms; the denominator's only primes are 2 and 5. Returns
 * 0 if the integers might not fit into words. `out` is 0 before. */
static int set_scaled_word(fmpq_t out, uint64_t value, long shift) {
    enum { FIVES = 27, TENS = 19 }; /* 5^27 and 10^19 fit in 64 bits */
    if (shift > TENS || value == 0)
        return value == 0;
    if (shift >= 0) {
        fmpz_set_ui(fmpq_numref(out), value);
        fmpz_mul_ui(fmpq_numref(out), fmpq_numref(out), n_pow(10, (ulong)shift));
        return 1;
    }
    long twos = -shift, fives = twos;
    for (; fives > 0 && value % 5 == 0; fives--)
        value /= 5;
    for (; twos > 0 && value % 2 == 0; twos--)
        value /= 2;
    if (fives > FIVES)
        return 0;
    fmpz_set_ui(fmpq_numref(out), value);
    fmpz_set_ui(fmpq_denref(out), n_pow(5, (ulong)fives));
    fmpz_mul_2exp(fmpq_denref(out), fmpq_denref(out), (ulong)twos);
    return 1;
}

/* Read a short token, as almost all are, in machine words. Returns 0 if words are too short, or the
 * denominator is 0. `out` is 0 before. */
static int set_short(fmpq_t out, const shape *s) {
    uint64_t value = 0, denominator = 0;
    if (!append_digits(&value, s->whole, s->whole_count))
        return 0;
    if (s->denominator == NULL)
        return append_digits(&value, s->fraction, s->fraction_count) &&
               set_scaled_word(out, value, s->exponent - (long)s->fraction_count);
    if (!append_digits(&denominator, s->denominator, s->denominator_count) || denominator == 0)
        return 0;
    uint64_t common = n_gcd(value, denominator);
    fmpz_set_ui(fmpq_numref(out), value / common);
    fmpz_set_ui(fmpq_denref(out), denominator / common);
    return 1;
}

static graze_status set_ratio(fmpq_t out, graze_context *context, const shape *s) {
    if (!set_digits(fmpq_numref(out), s->whole, s->whole_count, NULL, 0) ||
        !set_digits(fmpq_denref(out), s->denominator, s->denominator_count, NULL, 0))
        return context_fail(context, GRAZE_ESYSTEM, "no memory for a number");
    if (fmpz_is_zero(fmpq_denref(out))) {
        fmpz_one(fmpq_denref(out));
        return context_fail(context, GRAZE_EINPUT, "a ratio has the denominator 0");
    }
    fmpq_canonicalise(out);
    return GRAZE_OK;
}

graze_status rational_parse(fmpq_t out, graze_context *context, const char *text, size_t length) {
    int shown = length > SHOWN ? SHOWN : (int)length;
    const char *more = length > SHOWN ? "..." : "";
    shape s;
    fmpq_zero(out);
    if (!token_shape(&s, text, length)) {
        return context_fail(
            context, GRAZE_EINPUT,
            "'%.*s%s' is not a number; expected one such as -12, 0.1, 1.5e-3, "
            "22/7%s",
            shown, text, more,
            memchr(text, ',', length) ? "; expected a decimal point in place of the comma" : "");
    }
    unsigned long limit = context->limits[GRAZE_LIMIT_DIGITS];
    if (written_out(&s) > limit || s.denominator_count > limit) {
        graze_status status = context_limit(context, GRAZE_LIMIT_DIGITS, "digits written out");
        return context_at(context, status, "'%.*s%s'", shown, text, more);
    }
    graze_status status = GRAZE_OK;
    int done = set_short(out, &s);
    if (!done && s.denominator != NULL)
        status = set_ratio(out, context, &s);
    else if (!done && !set_decimal(out, &s))
        status = context_fail(context, GRAZE_ESYSTEM, "no memory for a number");
    if (status == GRAZE_OK && s.negative)
        fmpq_neg(out, out);
    if (status == GRAZE_OK)
        status = rational_round(out, context, context->rounding);
    return status == GRAZE_OK ? status : context_at(context, status, "'%.*s%s'", shown, text, more);
}

/* |value|, which fits into a word. */
static uint64_t small_magnitude(const fmpz_t value) {
    if (fmpz_sgn(value) >= 0)
        return fmpz_get_ui(value);
    LOCAL(fmpz, positive);
    fmpz_neg(positive, value);
    return fmpz_get_ui(positive);
}

int rational_is_canonical(const mpq_t value) {
    const mpz_srcptr top = mpq_numref(value), bottom = mpq_denref(value);
    const uint64_t fives = UINT64_C(7450580596923828125); /* 5^27, the largest in 64 bits */
    if (mpz_sgn(bottom) <= 0)
        return 0;
    if (mpz_size(top) > 1 || mpz_size(bottom) > 1) {
        LOCAL(mpz, common);
        mpz_gcd(common, top, bottom);
        return mpz_cmp_ui(common, 1) == 0;
    }
    uint64_t numerator = mpz_getlimbn(top, 0), denominator = mpz_getlimbn(bottom, 0);
    uint64_t odd = denominator / (denominator & -denominator);
    if (fives % odd != 0)
        return n_gcd(numerator, denominator) == 1;
    return (odd == denominator || numerator % 2 != 0) && (odd == 1 || numerator % 5 != 0);
}

/* Write the digits of a word, the last one just before `end`. Returns where they begin. */
static char *word_digits(char *end, uint64_t value) {
    do {
        *--end = (char)('0' + value % 10);
        value /= 10;
    } while (value > 0);
    return end;
}

/* Write an integer and a NUL to `at`. Returns the place of the NUL. */
static char *put_integer(char *at, const fmpz_t value) {
    if (!fmpz_abs_fits_ui(value)) {
        fmpz_get_str(at, 10, value);
        return at + strlen(at);
    }
    char digits[20];
    const char *start = word_digits(digits + sizeof digits, small_magnitude(value));
    size_t count = (size_t)(digits + sizeof digits - start);
    *at = '-';
    at += fmpz_sgn(value) < 0;
    memcpy(at, start, count);
    at[count] = '\0';
    return at + count;
}

/* A digit takes more than 3 bits; 5 bytes come on top, for a first digit of each integer, a sign, a
 * slash and a NUL. */
size_t rational_room(const fmpq_t value) {
    return (fmpz_bits(fmpq_numref(value)) + fmpz_bits(fmpq_denref(value))) / 3 + 5;
}

size_t rational_write(char *text, const fmpq_t value) {
    char *end = put_integer(text, fmpq_numref(value));
    if (!fmpz_is_one(fmpq_denref(value))) {
        *end = '/';
        end = put_integer(end + 1, fmpq_denref(value));
    }
    return (size_t)(end - text);
}

char *rational_text(const fmpq_t value) {
    char *text = malloc(rational_room(value));
    if (text != NULL)
        rational_write(text, value);
    return text;
}
