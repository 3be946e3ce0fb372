/* Expressions in t and s: text to rational function, by recursive descent.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Invariant: `place` is the first byte not yet read. After the first failure in `calculation` every
 * function returns at once, and its value has no meaning.
 */
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "input/motion/draft.h"

enum { SHOWN = 60 };
enum { CHARACTERS_A_UNIT = 16 }; /* of work */

typedef struct parser {
    calculation calculation;
    const char *text;
    size_t place, length;
    unsigned long depth;
    const fmpz_poly_q_struct *t, *s;
} parser;

static void parse_sum(parser *p, fmpz_poly_q_t out);

static int has_failed(const parser *p) {
    return p->calculation.status != GRAZE_OK;
}

/* Add the expression and the place in it to the message of a failure. */
static void tell_place(parser *p, size_t place) {
    int shown = p->length > SHOWN ? SHOWN : (int)p->length;
    p->calculation.status =
        context_at(p->calculation.context, p->calculation.status, "'%.*s%s', character %zu", shown,
                   p->text, p->length > SHOWN ? "..." : "", place + 1);
}

static void fail_at(parser *p, size_t place, const char *what) {
    p->calculation.status = context_fail(p->calculation.context, GRAZE_EINPUT, "%s", what);
    tell_place(p, place);
}

static int is_digit(char c) {
    return c >= '0' && c <= '9';
}

/* The byte at `place`, NUL at the end; blanks are skipped. A NUL in the text is no end, but no rule
 * takes it either. */
static char peek(parser *p) {
    while (p->place < p->length && (p->text[p->place] == ' ' || p->text[p->place] == '\t' ||
                                    p->text[p->place] == '\n' || p->text[p->place] == '\r'))
        p->place++;
    return p->place < p->length ? p->text[p->place] : '\0';
}

static char byte_at(const parser *p, size_t place) {
    return place < p->length ? p->text[place] : '\0';
}

static size_t digits_end(const parser *p, size_t place) {
    while (is_digit(byte_at(p, place)))
        place++;
    return place;
}

static size_t number_end(const parser *p, size_t place) {
    place = digits_end(p, place);
    if (byte_at(p, place) == '.')
        place = digits_end(p, place + 1);
    if (byte_at(p, place) == 'e' || byte_at(p, place) == 'E') {
        char sign = byte_at(p, place + 1);
        size_t digits = place + 1 + (sign == '+' || sign == '-');
        if (is_digit(byte_at(p, digits)))
            place = digits_end(p, digits);
    }
    return place;
}

static void read_literal(parser *p, fmpz_poly_q_t out, size_t end) {
    LOCAL(fmpq, value);
    p->calculation.status =
        rational_parse(value, p->calculation.context, p->text + p->place, end - p->place);
    if (has_failed(p)) {
        tell_place(p, p->place);
    } else {
        quotient_set_rational(out, value);
        quotient_check(&p->calculation, out);
        p->place = end;
    }
}

static void read_variable(parser *p, fmpz_poly_q_t out, const fmpz_poly_q_struct *value) {
    if (value == NULL) {
        fail_at(p, p->place, "expected a number here, without t and s");
        return;
    }
    fmpz_poly_q_set(out, value);
    p->place++;
}

static void parse_bracket(parser *p, fmpz_poly_q_t out) {
    size_t opened = p->place++;
    if (++p->depth > p->calculation.context->limits[GRAZE_LIMIT_DEPTH]) {
        p->calculation.status =
            context_limit(p->calculation.context, GRAZE_LIMIT_DEPTH, "nesting of brackets");
        tell_place(p, opened);
        return;
    }
    parse_sum(p, out);
    p->depth--;
    if (has_failed(p))
        return;
    if (peek(p) != ')') {
        fail_at(p, opened, "this bracket is not closed where its contents end; expected )");
        return;
    }
    p->place++;
}

/* The length of the name at p->place if it is of a function or a constant that is not rational,
 * else 0. */
static int transcendental_length(const parser *p) {
    static const char *const names[] = {"sin", "cos", "tan", "sqrt", "exp", "log", "pi", "atan"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        size_t n = strlen(names[k]);
        if (n <= p->length - p->place && memcmp(p->text + p->place, names[k], n) == 0)
            return (int)n;
    }
    return 0;
}

static void parse_primary(parser *p, fmpz_poly_q_t out) {
    char c = peek(p);
    if (p->place < p->length && transcendental_length(p) > 0) {
        fail_at(p, p->place,
                "motions are rational functions of t; expected rotate with tan_half, turn, or "
                "pieces that `graze motion` makes of degrees");
    } else if (c == '(') {
        parse_bracket(p, out);
    } else if (c == 't') {
        read_variable(p, out, p->t);
    } else if (c == 's') {
        read_variable(p, out, p->s);
    } else if (is_digit(c) || c == '.') {
        read_literal(p, out, number_end(p, p->place));
    } else {
        fail_at(p, p->place, "expected a number, t, s or ( here");
    }
}

static void read_exponent(parser *p, fmpz_t n) {
    char sign = peek(p);
    size_t start = p->place;
    p->place += sign == '+' || sign == '-';
    size_t end = digits_end(p, p->place);
    if (end == p->place || byte_at(p, end) == '.' || number_end(p, p->place) != end) {
        fail_at(p, start, "expected an integer in digits after ^");
        return;
    }
    LOCAL(fmpq, value);
    calculation *c = &p->calculation;
    c->status = rational_parse(value, c->context, p->text + p->place, end - p->place);
    if (has_failed(p))
        tell_place(p, start);
    fmpz_set(n, fmpq_numref(value));
    if (sign == '-')
        fmpz_neg(n, n);
    p->place = end;
}

static void parse_power(parser *p, fmpz_poly_q_t out) {
    parse_primary(p, out);
    if (has_failed(p) || peek(p) != '^')
        return;
    size_t operator= p->place++;
    LOCAL(fmpz, n);
    read_exponent(p, n);
    if (!has_failed(p)) {
        quotient_power(&p->calculation, out, out, n);
        if (has_failed(p))
            tell_place(p, operator);
        else if (peek(p) == '^')
            fail_at(p, p->place, "a^b^c has no meaning here; expected (a^b)^c");
    }
}

static void parse_signed(parser *p, fmpz_poly_q_t out) {
    int negative = 0;
    for (char c = peek(p); c == '+' || c == '-'; c = peek(p)) {
        negative ^= c == '-';
        p->place++;
    }
    parse_power(p, out);
    if (negative && !has_failed(p))
        fmpz_poly_q_neg(out, out);
}

/* The two levels of left-associative operators differ in their operators and operands alone. */
static void parse_chain(
    parser *p, fmpz_poly_q_t out, const char operators[2], void (*operand)(parser *, fmpz_poly_q_t),
    void (*first)(calculation *, fmpz_poly_q_t, const fmpz_poly_q_t, const fmpz_poly_q_t),
    void (*second)(calculation *, fmpz_poly_q_t, const fmpz_poly_q_t, const fmpz_poly_q_t)) {
    operand(p, out);
    LOCAL(fmpz_poly_q, right);
    while (!has_failed(p)) {
        char c = peek(p);
        if (c == '\0' || (c != operators[0] && c != operators[1]))
            break;
        size_t operator= p->place++;
        operand(p, right);
        if (!has_failed(p)) {
            (c == operators[0] ? first : second)(&p->calculation, out, out, right);
            if (has_failed(p))
                tell_place(p, operator);
        }
    }
}

static void parse_product(parser *p, fmpz_poly_q_t out) {
    parse_chain(p, out, "*/", parse_signed, quotient_mul, quotient_div);
}

static void parse_sum(parser *p, fmpz_poly_q_t out) {
    parse_chain(p, out, "+-", parse_product, quotient_add, quotient_sub);
}

graze_status expression_value(fmpz_poly_q_t out, graze_context *context, const char *text,
                              size_t length, const fmpz_poly_q_struct *t,
                              const fmpz_poly_q_struct *s) {
    parser p = {.calculation = {context, GRAZE_OK}, .text = text, .length = length, .t = t, .s = s};
    calculation_spend(&p.calculation, length / CHARACTERS_A_UNIT);
    if (has_failed(&p))
        return p.calculation.status;
    if (rational_is_token(text, length)) {
        read_literal(&p, out, length);
        return p.calculation.status;
    }
    parse_sum(&p, out);
    if (!has_failed(&p)) {
        peek(&p);
        if (p.place < length)
            fail_at(&p, p.place, "expected an operator or the end here");
    }
    return p.calculation.status;
}
