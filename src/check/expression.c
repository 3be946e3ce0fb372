/* Expressions by recursive descent:
 *   sum = term {(+|-) term};  term = signed {(*|/) signed};  signed = {+|-} power;
 *   power = atom [^ [+|-] digits];  atom = number | t | s | ( sum )
 * SPDX-License-Identifier: MIT
 */
#include "expression.h"

#include <string.h>

typedef struct parser {
    word rest, whole;
    const fraction *s;
    const char *path;
    size_t line, depth;
} parser;

static _Noreturn void fail(const parser *p) {
    give_up("%s:%zu: '%.*s' is no expression at character %zu", p->path, p->line, WORD(p->whole),
            (size_t)(p->rest.at - p->whole.at) + 1);
}

static char peek(parser *p) {
    while (p->rest.length > 0 && *p->rest.at && strchr(" \t\r\n", *p->rest.at)) {
        p->rest.at++;
        p->rest.length--;
    }
    return p->rest.length > 0 ? *p->rest.at : '\0';
}

static int take(parser *p, char c) {
    if (peek(p) != c)
        return 0;
    p->rest.at++;
    p->rest.length--;
    return 1;
}

static size_t digits_from(const parser *p, size_t k) {
    size_t n = k;
    while (n < p->rest.length && p->rest.at[n] >= '0' && p->rest.at[n] <= '9')
        n++;
    return n - k;
}

static char char_at(const parser *p, size_t k) {
    return k < p->rest.length ? p->rest.at[k] : '\0';
}

/* A decimal: its sign is no part of it, and / is the operation. */
static void read_number(parser *p, fraction *out) {
    size_t n = digits_from(p, 0);
    if (char_at(p, n) == '.')
        n += 1 + digits_from(p, n + 1);
    if (char_at(p, n) == 'e' || char_at(p, n) == 'E') {
        size_t sign = char_at(p, n + 1) == '+' || char_at(p, n + 1) == '-';
        n += 1 + sign + digits_from(p, n + 1 + sign);
    }
    mpq_t value;
    mpq_init(value);
    if (!number_read(value, (word){p->rest.at, n}))
        fail(p);
    fraction_set_q(out, value);
    mpq_clear(value);
    p->rest.at += n;
    p->rest.length -= n;
}

static void read_sum(parser *p, fraction *out);

static void read_atom(parser *p, fraction *out) {
    if (take(p, '(')) {
        if (++p->depth > MOST_DEPTH)
            fail(p);
        read_sum(p, out);
        if (!take(p, ')'))
            fail(p);
        p->depth--;
    } else if (p->s && take(p, 't')) {
        mpz_t one;
        mpz_init_set_ui(one, 1);
        poly_zeros(&out->num, 2);
        mpz_set(out->num.c[1], one);
        poly_set_z(&out->den, one);
        mpz_clear(one);
    } else if (p->s && take(p, 's')) {
        fraction_set(out, p->s);
    } else {
        read_number(p, out);
    }
}

static void read_power(parser *p, fraction *out) {
    read_atom(p, out);
    if (!take(p, '^'))
        return;
    int negative = take(p, '-');
    if (!negative)
        (void)take(p, '+');
    (void)peek(p);
    size_t n = digits_from(p, 0), exponent = 0;
    if (n == 0)
        fail(p);
    for (size_t k = 0; k < n && exponent <= MOST_DEGREE; k++)
        exponent = 10 * exponent + (size_t)(p->rest.at[k] - '0');
    if (exponent > MOST_DEGREE)
        give_up("%s:%zu: an exponent above %d", p->path, p->line, MOST_DEGREE);
    p->rest.at += n;
    p->rest.length -= n;
    fraction power;
    mpq_t one;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    fraction_init(&power);
    fraction_set_q(&power, one);
    for (size_t k = 0; k < exponent; k++)
        fraction_apply(&power, negative ? '/' : '*', &power, out);
    fraction_set(out, &power);
    fraction_clear(&power);
    mpq_clear(one);
    if (peek(p) == '^')
        fail(p);
}

static void read_signed(parser *p, fraction *out) {
    int negative = 0;
    for (;;) {
        if (take(p, '-'))
            negative = !negative;
        else if (!take(p, '+'))
            break;
    }
    read_power(p, out);
    fraction zero;
    fraction_init(&zero);
    if (negative)
        fraction_apply(out, '-', &zero, out);
    fraction_clear(&zero);
}

static void read_term(parser *p, fraction *out) {
    fraction next;
    fraction_init(&next);
    read_signed(p, out);
    for (char op = peek(p); op == '*' || op == '/'; op = peek(p)) {
        (void)take(p, op);
        read_signed(p, &next);
        fraction_apply(out, op, out, &next);
    }
    fraction_clear(&next);
}

static void read_sum(parser *p, fraction *out) {
    fraction next;
    fraction_init(&next);
    read_term(p, out);
    for (char op = peek(p); op == '+' || op == '-'; op = peek(p)) {
        (void)take(p, op);
        read_term(p, &next);
        fraction_apply(out, op, out, &next);
    }
    fraction_clear(&next);
}

void expression_read(fraction *out, word text, const fraction *s, const char *path, size_t line) {
    parser p = {text, text, s, path, line, 0};
    read_sum(&p, out);
    if (peek(&p) || p.rest.length > 0)
        fail(&p);
}
