/* Reads motion files of plain pieces, which have exactly this form:
 *   {"dimension": D, "pieces": [PIECE, ...]}
 *   PIECE = {"t": [NUMBER, NUMBER], ROW "transform": {"translate": [ENTRY, ...]}}
 *         | {"t": [NUMBER, NUMBER], ROW "transform": {"matrix": [[ENTRY, ...], ...]}}
 *   ROW = nothing | "row": COUNT,
 *   ENTRY = A | (A)/(A);  A = [-] TERM {(+|-) TERM};  TERM = NUMBER | [NUMBER*] t [^COUNT]
 * NUMBERs and ENTRYs stand in quotes or bare.
 * SPDX-License-Identifier: MIT
 */
#include "motion.h"

/* num / den, den not zero. */
typedef struct fraction {
    poly num, den;
} fraction;

static void fraction_clear(fraction *f) {
    poly_clear(&f->num);
    poly_clear(&f->den);
}

static void set_constant(poly *out, long value) {
    poly_extend(out, 1);
    mpz_set_si(out->c[0], value);
    out->n = 1;
    poly_trim(out);
}

static void multiply(poly *p, const poly *q) {
    poly product = {0};
    poly_add_product(&product, p, q, 1);
    poly_clear(p);
    *p = product;
}

/* Read a value; quotes around it are removed. */
static word value(source *f) {
    word w = token(f);
    (void)word_take(&w, "\"");
    return word_cut(&w, "\"");
}

static void read_number(mpq_t out, source *f) {
    if (!number_read(out, value(f)))
        source_fail(f, "a number is expected");
}

/* Skip blanks, then remove one character if it is in `any`; returns 1 if it was, else 0. */
static int take(word *w, const char *any) {
    while (word_take(w, " "))
        ;
    return word_take(w, any);
}

/* Read a term c t^power; returns 1, or 0 if w does not begin with one. */
static int read_term(mpq_t c, size_t *power, word *w) {
    word number = word_cut(w, "* )t");
    *power = 0;
    mpq_set_ui(c, 1, 1);
    if (number.length > 0 && !number_read(c, number))
        return 0;
    if (number.length > 0 && !take(w, "*"))
        return 1;
    if (!take(w, "t"))
        return 0;
    *power = 1;
    if (!take(w, "^"))
        return 1;
    (void)take(w, "");
    return count_read(power, word_digits(w));
}

/* out += c t^power: num/den + c t^power = (num q + p den t^power) / (den q), c = p / q. `out->den`
 * is an integer. */
static void add_term(fraction *out, const mpq_t c, size_t power, int minus) {
    mpz_t z;
    mpz_init(z);
    mpz_mul(z, mpq_numref(c), out->den.c[0]);
    poly_scale(&out->num, mpq_denref(c));
    poly_scale(&out->den, mpq_denref(c));
    poly_extend(&out->num, power + 1);
    (minus ? mpz_sub : mpz_add)(out->num.c[power], out->num.c[power], z);
    poly_trim(&out->num);
    motion_check_size(&out->num);
    motion_check_size(&out->den);
    mpz_clear(z);
}

/* Read a polynomial A of the grammar into `out`, whose denominator is an integer. */
static int read_poly(fraction *out, word *w) {
    mpq_t c;
    size_t power;
    mpq_init(c);
    set_constant(&out->num, 0);
    set_constant(&out->den, 1);
    int minus = take(w, "-"), good = 1, more = 1;
    while (good && more) {
        (void)take(w, "");
        good = read_term(c, &power, w);
        if (good && power > MOST_DEGREE)
            give_up("the motion has a polynomial of degree above %d", MOST_DEGREE);
        if (good)
            add_term(out, c, power, minus);
        minus = take(w, "-");
        more = minus || take(w, "+");
    }
    mpq_clear(c);
    return good;
}

/* A, or (A)/(A). */
static void read_entry(fraction *out, source *f) {
    word w = value(f), rest = w;
    fraction top = {{0}, {0}}, bottom = {{0}, {0}};
    int quotient = take(&rest, "("), good = read_poly(&top, &rest);
    set_constant(&bottom.num, 1);
    set_constant(&bottom.den, 1);
    if (good && quotient)
        good = take(&rest, ")") && take(&rest, "/") && take(&rest, "(") &&
               read_poly(&bottom, &rest) && take(&rest, ")") && bottom.num.n > 0;
    (void)take(&rest, "");
    if (!good || rest.length > 0)
        give_up("%s:%zu: '%.*s' is neither A nor (A)/(B); expected what graze convert writes",
                f->path, f->line, WORD(w));
    set_constant(&out->num, 0);
    set_constant(&out->den, 0);
    poly_add_product(&out->num, &top.num, &bottom.den, 1);
    poly_add_product(&out->den, &top.den, &bottom.num, 1);
    fraction_clear(&top);
    fraction_clear(&bottom);
}

/* Set `forward` to the entries over the least common multiple of their denominators, and clear the
 * entries. */
static void make_forward(piece *p, fraction *entry) {
    poly g = {0}, factor = {0}, *weight = &p->forward[WEIGHT];
    set_constant(weight, 1);
    for (int k = 0; k < WEIGHT; k++) {
        poly_common(&g, weight, &entry[k].den);
        poly_set(&factor, &entry[k].den);
        must(poly_divide(&factor, &g), "motion: a divisor does not divide");
        multiply(weight, &factor);
        motion_check_size(weight);
    }
    for (int k = 0; k < WEIGHT; k++) {
        poly_set(&factor, weight);
        must(poly_divide(&factor, &entry[k].den), "motion: a divisor does not divide");
        poly_add_product(&p->forward[k], &entry[k].num, &factor, 1);
        fraction_clear(&entry[k]);
    }
    poly_clear(&g);
    poly_clear(&factor);
}

/* Read a transform: d rows of d + 1 entries, or the last column alone; the other entries are those
 * of the identity. */
static void read_transform(fraction *entry, source *f, int d) {
    for (int k = 0; k < WEIGHT; k++) {
        set_constant(&entry[k].num, k / 4 == k % 4);
        set_constant(&entry[k].den, 1);
    }
    token_want(f, "{");
    word kind = token(f);
    int matrix = word_is(kind, "\"matrix\"");
    if (!matrix && !word_is(kind, "\"translate\""))
        source_fail(f, "a transform is neither matrix nor translate; graze convert writes those");
    token_want(f, ": [");
    for (int i = 0; i < d; i++) {
        token_want(f, i > 0 ? "," : "");
        token_want(f, matrix ? "[" : "");
        for (int k = matrix ? 0 : d; k <= d; k++) {
            read_entry(&entry[4 * i + (k < d ? k : 3)], f);
            token_want(f, k < d ? "," : "");
        }
        token_want(f, matrix ? "]" : "");
    }
    token_want(f, "] }");
}

/* Read up to the transform. A `row`, the number of a line in a log, is skipped. */
static void pass_row(source *f) {
    word key = token(f);
    if (word_is(key, "\"row\"")) {
        token_want(f, ":");
        word row = token(f), digits = word_digits(&row);
        if (digits.length == 0 || row.length > 0)
            source_fail(f, "a row is the line of a log, an integer");
        token_want(f, ",");
        key = token(f);
    }
    if (!word_is(key, "\"transform\""))
        source_fail(f, "a transform is expected");
    token_want(f, ":");
}

static void read_piece(motion *m, source *f) {
    fraction entry[WEIGHT] = {{{0}, {0}}};
    piece next = {.det = {0}};
    mpq_inits(next.lo, next.hi, NULL);
    work_allow(STEP_WORK);
    token_want(f, "{ \"t\" : [");
    read_number(next.lo, f);
    token_want(f, ",");
    read_number(next.hi, f);
    token_want(f, "] ,");
    pass_row(f);
    read_transform(entry, f, m->d);
    token_want(f, "}");
    make_forward(&next, entry);
    motion_add(m, &next);
}

motion motion_read(const char *path, const char *sha256) {
    source f = source_open(path, sha256, "{}[]:,\"" BLANKS);
    motion m = {.d = 2};
    token_want(&f, "{ \"dimension\" :");
    word d = token(&f);
    if (!word_is(d, "2") && !word_is(d, "3"))
        source_fail(&f, "the dimension is neither 2 nor 3");
    m.d = word_is(d, "2") ? 2 : 3;
    token_want(&f, ", \"pieces\" : [");
    do
        read_piece(&m, &f);
    while (token_goes_on(&f, "]"));
    token_want(&f, "}");
    if (token(&f).length > 0)
        source_fail(&f, "text follows the motion");
    return m;
}
