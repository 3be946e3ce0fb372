/* Motion files of plain pieces, and nothing else, in this order:
 *   {"dimension": D, "pieces": [PIECE, ...]}
 *   PIECE = {"t": [NUMBER, NUMBER], "transform": {"translate": [ENTRY, ...]}}
 *         | {"t": [NUMBER, NUMBER], "transform": {"matrix": [[ENTRY, ...], ...]}}
 *   ENTRY = A | (A)/(A);  A = [-] TERM {(+|-) TERM};  TERM = NUMBER | [NUMBER*] t [^COUNT]
 * NUMBERs and ENTRYs in quotes or bare.
 * SPDX-License-Identifier: MIT
 */
#include "motion.h"

static const char marks[] = "{}[]:,";

typedef struct reader {
    source f;
    int d;
} reader;

static void want(reader *r, const char *expected) {
    token_want(&r->f, marks, expected);
}

static int goes_on(reader *r) {
    return token_goes_on(&r->f, marks, "]");
}

/* What stands between quotes, or bare. */
static word value(reader *r) {
    word w = token(&r->f, marks);
    if (w.length > 1 && *w.at == '"')
        w = (word){w.at + 1, w.length - 2};
    return w;
}

static void read_number(mpq_t out, reader *r) {
    if (!number_read(out, value(r)))
        source_fail(&r->f, "a number is expected");
}

/* ------------------------------------------------------------------------------------- entries */

static void blanks(word *w) {
    while (word_take(w, " "))
        ;
}

/* Take a character, and blanks before it, off an entry if it stands there. */
static int take(word *w, const char *any) {
    blanks(w);
    return word_take(w, any);
}

/* c t^power: 1, or 0 if none stands there. */
static int read_term(mpq_t c, size_t *power, word *w) {
    word number = {w->at, 0};
    while (number.length < w->length && w->at[number.length] != '*' &&
           w->at[number.length] != ' ' && w->at[number.length] != ')' &&
           w->at[number.length] != 't')
        number.length++;
    *power = 0;
    mpq_set_ui(c, 1, 1);
    if (number.length > 0) {
        if (word_digits(number) == 0 || !number_read(c, number))
            return 0;
        word_skip(w, number.length);
        if (!take(w, "*"))
            return 1;
        blanks(w);
    }
    if (!word_take(w, "t"))
        return 0;
    *power = 1;
    if (!take(w, "^"))
        return 1;
    blanks(w);
    word digits = {w->at, word_digits(*w)};
    word_skip(w, digits.length);
    return count_read(power, digits);
}

/* out = A: numerators over one integer. */
static int read_poly(fraction *out, word *w) {
    mpq_t c;
    mpz_t z;
    mpq_init(c);
    mpz_init(z);
    poly_set_si(&out->num, 0);
    poly_set_si(&out->den, 1);
    int minus = take(w, "-"), good = 1, more = 1;
    while (good && more) {
        size_t power;
        blanks(w);
        good = read_term(c, &power, w);
        if (good && power > MOST_DEGREE)
            give_up("the motion has a polynomial of degree above %d", MOST_DEGREE);
        if (good) { /* num/den + c t^power = (num q + p den t^power) / (den q), c = p / q */
            mpz_mul(z, mpq_numref(c), out->den.c[0]);
            poly_scale(&out->num, mpq_denref(c));
            poly_scale(&out->den, mpq_denref(c));
            poly_extend(&out->num, power + 1);
            (minus ? mpz_sub : mpz_add)(out->num.c[power], out->num.c[power], z);
            poly_trim(&out->num);
            motion_check_size(&out->num);
            motion_check_size(&out->den);
        }
        minus = take(w, "-");
        more = minus || take(w, "+");
    }
    mpq_clear(c);
    mpz_clear(z);
    return good;
}

/* (A)/(B), over integers. */
static int read_quotient(fraction *out, word *w) {
    fraction top = {{0}, {0}}, bottom = {{0}, {0}};
    int good = read_poly(&top, w) && take(w, ")") && take(w, "/") && take(w, "(") &&
               read_poly(&bottom, w) && take(w, ")") && bottom.num.n > 0;
    if (good) {
        poly_add_product(&out->num, &top.num, &bottom.den, 1);
        poly_add_product(&out->den, &top.den, &bottom.num, 1);
    }
    fraction *all[] = {&top, &bottom};
    for (int k = 0; k < 2; k++) {
        poly_clear(&all[k]->num);
        poly_clear(&all[k]->den);
    }
    return good;
}

static void read_entry(fraction *out, reader *r) {
    word w = value(r), rest = w;
    int good = take(&rest, "(") ? read_quotient(out, &rest) : read_poly(out, &rest);
    blanks(&rest);
    if (!good || rest.length > 0)
        give_up("%s:%zu: '%.*s' is neither A nor (A)/(B); expected what graze convert writes",
                r->f.path, r->f.line, WORD(w));
}

/* -------------------------------------------------------------------------------------- pieces */

/* d rows of d + 1, or their last column alone. */
static void read_transform(fraction *entry, reader *r) {
    want(r, "{");
    word kind = token(&r->f, marks);
    int matrix = word_is(kind, "\"matrix\""), d = r->d;
    if (!matrix && !word_is(kind, "\"translate\""))
        source_fail(&r->f,
                    "a transform is neither matrix nor translate; graze convert writes those");
    want(r, ":");
    want(r, "[");
    for (int i = 0; i < d; i++) {
        if (matrix)
            want(r, "[");
        for (int k = matrix ? 0 : d; k <= d; k++) {
            read_entry(&entry[4 * i + k], r);
            if (k < d && !goes_on(r))
                source_fail(&r->f, "a row is too short");
        }
        if (matrix)
            want(r, "]");
        if (i + 1 < d && !goes_on(r))
            source_fail(&r->f, "a row or an entry is missing");
    }
    want(r, "]");
    want(r, "}");
    for (int k = 0; !matrix && k < d * 4; k++) {
        if (k % 4 < d)
            poly_set_si(&entry[k].num, k / 4 == k % 4);
        if (k % 4 < d)
            poly_set_si(&entry[k].den, 1);
    }
}

static void read_piece(motion *m, reader *r) {
    fraction entry[WEIGHT] = {{{0}, {0}}};
    mpq_t lo, hi;
    mpq_inits(lo, hi, NULL);
    want(r, "{");
    want(r, "\"t\"");
    want(r, ":");
    want(r, "[");
    read_number(lo, r);
    want(r, ",");
    read_number(hi, r);
    want(r, "]");
    want(r, ",");
    want(r, "\"transform\"");
    want(r, ":");
    read_transform(entry, r);
    want(r, "}");
    motion_add(m, lo, hi, entry);
    mpq_clears(lo, hi, NULL);
}

motion motion_read(const char *path, const char *text, size_t length) {
    reader r = {.f = source_open(path, text, length)};
    motion m = {.d = 2};
    want(&r, "{");
    want(&r, "\"dimension\"");
    want(&r, ":");
    word d = token(&r.f, marks);
    if (!word_is(d, "2") && !word_is(d, "3"))
        source_fail(&r.f, "the dimension is neither 2 nor 3");
    m.d = r.d = word_is(d, "2") ? 2 : 3;
    want(&r, ",");
    want(&r, "\"pieces\"");
    want(&r, ":");
    want(&r, "[");
    do
        read_piece(&m, &r);
    while (goes_on(&r));
    want(&r, "}");
    if (token(&r.f, marks).length > 0)
        source_fail(&r.f, "text follows the motion");
    return m;
}
