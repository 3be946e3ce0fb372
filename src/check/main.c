/* graze-check SOLID MOTION CERTIFICATE [TABLE]: follow a certificate, line by line.
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "rows.h"
#include "trace.h"

static const char help[] =
    "graze-check SOLID MOTION CERTIFICATE [TABLE]: verify a certificate of graze certify\n"
    "\n"
    "Verifies each row's word, counts, case, class and pmc from SOLID (.off, .wkt), MOTION (JSON)\n"
    "and the certificate's hints alone; with TABLE, also that the table says the same, row by "
    "row.\n"
    "Needs GMP and nothing of graze.\n"
    "\n"
    "  --assume-legal    do not test whether the solid is legal; then the verdict says so\n"
    "  --help\n"
    "\n"
    "Exit status: 0 verified; 1 refuted: the message names line, row and claim; 2 could not "
    "check.\n"
    "\n"
    "Example: graze-check cube.off move.json certificate.txt table.csv\n";

typedef struct checker {
    lines l;
    head h;
    solid s;
    motion m;
    mpq_t *sign_times; /* of the head's line `signs` */
    size_t sign_count;
    trace r;
    table *table;
    int open;        /* a row is */
    verdict claimed; /* unused texts are "" */
    char *word;      /* the open row's claims, as they stand */
    size_t rows;
} checker;

static _Noreturn void fail(const checker *c, const char *what) {
    refute("%s:%zu: %s", c->l.path, c->l.line, what);
}

static word want(const checker *c, const char **at, const char *end, const char *what) {
    word w;
    if (!word_next(&w, at, end))
        refute("%s:%zu: %s is missing", c->l.path, c->l.line, what);
    return w;
}

static void want_end(const checker *c, const char **at, const char *end) {
    word w;
    if (word_next(&w, at, end))
        fail(c, "there is too much on the line");
}

/* A head line: KEY VALUE. */
static word head_value(checker *c, const char *key) {
    word line;
    if (!lines_next(&c->l, &line))
        fail(c, "the certificate ends in its head");
    const char *at = line.at, *end = at + line.length;
    if (!word_is(want(c, &at, end, key), key))
        refute("%s:%zu: '%s' is expected", c->l.path, c->l.line, key);
    word value = want(c, &at, end, "a value");
    want_end(c, &at, end);
    return value;
}

static int head_choice(checker *c, const char *key, const char *no, const char *yes) {
    word w = head_value(c, key);
    if (!word_is(w, no) && !word_is(w, yes))
        refute("%s:%zu: %s is '%s' or '%s'", c->l.path, c->l.line, key, no, yes);
    return word_is(w, yes);
}

static void head_hash(checker *c, const char *key, char out[65]) {
    word w = head_value(c, key);
    if (w.length != 64)
        fail(c, "a SHA-256 has 64 digits");
    memcpy(out, w.at, 64);
    out[64] = '\0';
}

static void read_signs(checker *c) {
    word line, w;
    if (!lines_next(&c->l, &line))
        fail(c, "the certificate ends in its head");
    const char *at = line.at, *end = at + line.length;
    if (!word_is(want(c, &at, end, "signs"), "signs"))
        fail(c, "'signs' is expected");
    size_t room = 0;
    while (word_next(&w, &at, end)) {
        c->sign_times = room_for(c->sign_times, c->sign_count, &room, sizeof *c->sign_times);
        mpq_init(c->sign_times[c->sign_count]);
        if (!number_read(c->sign_times[c->sign_count++], w))
            fail(c, "a time is not a number");
    }
}

static void read_head(checker *c) {
    if (!word_is(head_value(c, "graze-certificate"), "1"))
        give_up("%s: version 1 is expected", c->l.path);
    head_hash(c, "solid-sha256", c->h.solid);
    head_hash(c, "motion-sha256", c->h.motion);
    head_hash(c, "scene-sha256", c->h.scene);
    c->h.dimension = 2 + head_choice(c, "dimension", "2", "3");
    c->h.unsweep = head_choice(c, "operation", "sweep", "unsweep");
    c->h.combined = head_choice(c, "folds", "separate", "combined");
    c->h.triangulate = head_choice(c, "triangulate", "no", "yes");
    read_signs(c);
}

static char *read_hashed(const char *path, const char *expected, size_t *length) {
    char sha[65], *text = read_file(length, path);
    sha256_text(sha, text, *length);
    if (strcmp(sha, expected) != 0)
        refute("%s: its SHA-256 is not that of the certificate", path);
    return text;
}

/* One strict sign of p on each interval between the times, which begin with t0, end with t1 and
 * take in all break points. */
static void check_signs(const checker *c) {
    const motion *m = &c->m;
    size_t piece = 0;
    mpz_t *b = NULL;
    if (c->sign_count < 2 || !mpq_equal(c->sign_times[0], m->piece[0].lo) ||
        !mpq_equal(c->sign_times[c->sign_count - 1], m->piece[m->count - 1].hi))
        refute("motion: the times of signs do not go from t0 to t1");
    for (size_t k = 0; k + 1 < c->sign_count; k++) {
        const mpq_t *lo = (const mpq_t *)&c->sign_times[k];
        const mpq_t *hi = (const mpq_t *)&c->sign_times[k + 1];
        piece += mpq_cmp(*lo, m->piece[piece].hi) >= 0;
        if (mpq_cmp(*lo, *hi) >= 0 || piece == m->count || mpq_cmp(*hi, m->piece[piece].hi) > 0)
            refute("motion: the times of signs do not follow the pieces");
        const poly *p[] = {&m->piece[piece].forward_weight, &m->piece[piece].det};
        for (int i = 0; i < 2; i++) {
            b = grow(NULL, p[i]->n + 1, sizeof *b);
            for (size_t j = 0; j < p[i]->n; j++)
                mpz_init(b[j]);
            bernstein(b, p[i], p[i]->n - 1, *lo, *hi);
            if (strict_sign(b, p[i]->n) == 0)
                refute("motion: signs, interval %zu: the %s has no strict sign", k,
                       i ? "determinant" : "denominator");
            for (size_t j = 0; j < p[i]->n; j++)
                mpz_clear(b[j]);
            free(b);
        }
    }
}

static unsigned long read_count(const checker *c, const char **at, const char *end,
                                const char *what) {
    size_t out;
    if (!count_read(&out, want(c, at, end, what)))
        refute("%s:%zu: %s is not a count", c->l.path, c->l.line, what);
    return out;
}

/* The row's claims after its word are held to the word at once; the word to the intervals when the
 * row ends. */
static void begin_row(checker *c, const char *at, const char *end) {
    c->r.row = c->rows;
    c->r.line = c->l.line;
    for (int k = 0; k < c->h.dimension; k++)
        if (!number_read(c->r.point[k], want(c, &at, end, "a coordinate")))
            fail(c, "a coordinate is not a number");
    word w = want(c, &at, end, "the word");
    for (size_t k = 0; k < w.length; k++)
        if (w.at[k] != 'I' && w.at[k] != 'B' && w.at[k] != 'O')
            fail(c, "the word is not of the letters I, B and O");
    if (w.length > MOST_WORD)
        give_up("%s:%zu: a word of more than %d letters", c->l.path, c->l.line, MOST_WORD);
    c->word = grow(c->word, w.length + 1, 1);
    memcpy(c->word, w.at, w.length);
    c->word[w.length] = '\0';
    verdict v = verdict_of(c->word, w.length, c->h.unsweep, c->h.combined);
    if (!word_is(want(c, &at, end, "pmc"), v.pmc))
        fail(c, "pmc is not that of the word");
    if (!c->h.unsweep) {
        if (!word_is(want(c, &at, end, "the class"), v.class_))
            fail(c, "the class is not that of the word");
        if (!word_is(want(c, &at, end, "the definition"), v.definition))
            fail(c, "the definition is not that of the word");
        if (read_count(c, &at, end, "the case") != (unsigned long)v.position)
            fail(c, "the case is not that of the word");
        if (read_count(c, &at, end, "i") != v.i || read_count(c, &at, end, "t") != v.t ||
            read_count(c, &at, end, "k") != v.k)
            fail(c, "i, t or k is not that of the word");
    }
    want_end(c, &at, end);
    c->claimed = v;
    c->open = 1;
    trace_start(&c->r);
}

static void end_row(checker *c) {
    if (!c->open)
        return;
    trace_end(&c->r);
    if (strcmp(c->r.word, c->word) != 0)
        refute("line %zu, row %zu: the intervals' word is not the row's", c->l.line, c->rows);
    if (c->table)
        table_row(c->table, (const mpq_t *)c->r.point, c->word, &c->claimed);
    c->rows++;
    c->open = 0;
}

static void read_interval(checker *c, word kind, const char *at, const char *end) {
    mpq_t to;
    poly q;
    word w;
    mpq_init(to);
    poly_init(&q);
    if (!c->open)
        fail(c, "'row' is expected");
    if (!number_read(to, want(c, &at, end, "a time")))
        fail(c, "a time is not a number");
    while (word_next(&w, &at, end)) {
        if (q.n > MOST_DEGREE)
            give_up("%s:%zu: a polynomial of degree above %d", c->l.path, c->l.line, MOST_DEGREE);
        if (!integer_read(*poly_next(&q), w))
            fail(c, "a coefficient is not an integer");
    }
    int given = q.n > 0;
    poly_trim(&q);
    poly_make_primitive(&q);
    c->r.line = c->l.line;
    trace_interval(&c->r, kind, to, given ? &q : NULL);
    poly_clear(&q);
    mpq_clear(to);
}

static void read_rows(checker *c) {
    word line;
    while (lines_next(&c->l, &line)) {
        const char *at = line.at, *end = at + line.length;
        word w = want(c, &at, end, "'row', 'complete' or an interval");
        if (word_is(w, "row")) {
            end_row(c);
            begin_row(c, at, end);
        } else if (word_is(w, "complete")) {
            end_row(c);
            if (read_count(c, &at, end, "the number of rows") != c->rows)
                fail(c, "the number of rows is another");
            want_end(c, &at, end);
            if (lines_next(&c->l, &line))
                fail(c, "text follows 'complete'");
            return;
        } else
            read_interval(c, w, at, end);
    }
    fail(c, "the certificate ends without 'complete'");
}

static void check(const char *const *path, int assume_legal) {
    checker c = {.open = 0};
    size_t length;
    c.l = lines_open(path[2]);
    read_head(&c);
    char *text = read_hashed(path[0], c.h.solid, &length);
    c.s = solid_read(path[0], text, length, c.h.triangulate);
    free(text);
    text = read_hashed(path[1], c.h.motion, &length);
    c.m = motion_read(path[1], text, length);
    free(text);
    if (c.s.d != c.h.dimension || c.m.d != c.h.dimension)
        refute("%s: the dimension is not that of solid and motion", path[2]);
    if (!assume_legal)
        solid_check(&c.s);
    check_signs(&c);
    table t;
    if (path[3]) {
        t = table_open(path[3], &c.h);
        c.table = &t;
    }
    trace_init(&c.r, &c.s, &c.m, c.h.unsweep);
    read_rows(&c);
    if (c.table)
        table_end(c.table);
    printf("verified%s: %zu rows\n", assume_legal ? ", assuming a legal solid" : "", c.rows);
    trace_clear(&c.r);
}

int main(int argc, char **argv) {
    const char *path[4] = {NULL, NULL, NULL, NULL};
    int given = 0, assume_legal = 0;
    for (int k = 1; k < argc; k++) {
        if (strcmp(argv[k], "--help") == 0) {
            fputs(help, stdout);
            return VERIFIED;
        }
        if (strcmp(argv[k], "--assume-legal") == 0)
            assume_legal = 1;
        else if (argv[k][0] == '-' || given == 4)
            give_up("'%s' is not expected; see graze-check --help", argv[k]);
        else
            path[given++] = argv[k];
    }
    if (given < 3)
        give_up("SOLID MOTION CERTIFICATE [TABLE] are expected; see graze-check --help");
    check(path, assume_legal);
    return fflush(stdout) == 0 ? VERIFIED : NOT_CHECKED;
}
