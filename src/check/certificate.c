/* The grammar of certificates: proofs/certificate.md, section 1.
 * SPDX-License-Identifier: MIT
 */
#include "certificate.h"

#include <stdlib.h>
#include <string.h>

static _Noreturn void fail(const certificate *c, const char *what) {
    refute("%s:%zu: %s", c->l.path, c->l.line, what);
}

static word want(const certificate *c, const char **at, const char *end, const char *what) {
    word w;
    if (!word_next(&w, at, end))
        refute("%s:%zu: %s is missing", c->l.path, c->l.line, what);
    return w;
}

static void want_end(const certificate *c, const char *at, const char *end) {
    word w;
    if (word_next(&w, &at, end))
        fail(c, "there is too much on the line");
}

static size_t read_count(const certificate *c, const char **at, const char *end, const char *what) {
    size_t out;
    if (!count_read(&out, want(c, at, end, what)))
        refute("%s:%zu: %s is not a count", c->l.path, c->l.line, what);
    return out;
}

/* ---------------------------------------------------------------------------------------- head */

/* What follows KEY on the next line of the head. */
static word head_line(certificate *c, const char *key) {
    word line;
    if (!lines_next(&c->l, &line))
        fail(c, "the certificate ends in its head");
    const char *at = line.at, *end = at + line.length;
    if (!word_is(want(c, &at, end, key), key))
        refute("%s:%zu: expected '%s'", c->l.path, c->l.line, key);
    return (word){at, (size_t)(end - at)};
}

static word head_value(certificate *c, const char *key) {
    word rest = head_line(c, key);
    const char *at = rest.at, *end = at + rest.length;
    word value = want(c, &at, end, "a value");
    want_end(c, at, end);
    return value;
}

static int head_choice(certificate *c, const char *key, const char *no, const char *yes) {
    word w = head_value(c, key);
    if (!word_is(w, no) && !word_is(w, yes))
        refute("%s:%zu: %s; expected '%s' or '%s'", c->l.path, c->l.line, key, no, yes);
    return word_is(w, yes);
}

static void head_hash(certificate *c, const char *key, char out[65]) {
    word w = head_value(c, key);
    if (w.length != 64)
        fail(c, "a SHA-256 has 64 digits");
    memcpy(out, w.at, 64);
    out[64] = '\0';
}

certificate certificate_open(const char *path) {
    certificate c = {.l = lines_open(path)};
    if (!word_is(head_value(&c, "graze-certificate"), "1"))
        give_up("%s: expected version 1", path);
    head_hash(&c, "solid-sha256", c.h.solid);
    head_hash(&c, "motion-sha256", c.h.motion);
    head_hash(&c, "scene-sha256", c.h.scene);
    c.h.dimension = 2 + head_choice(&c, "dimension", "2", "3");
    c.h.unsweep = head_choice(&c, "operation", "sweep", "unsweep");
    c.h.combined = head_choice(&c, "folds", "separate", "combined");
    word w, rest = head_line(&c, "signs");
    const char *at = rest.at, *end = at + rest.length;
    for (size_t room = 0; word_next(&w, &at, end); c.time_count++) {
        c.times = room_for(c.times, c.time_count, &room, sizeof *c.times);
        mpq_init(c.times[c.time_count]);
        if (!number_read(c.times[c.time_count], w))
            fail(&c, "a time is not a number");
    }
    return c;
}

/* ---------------------------------------------------------------------------------------- rows */

/* A row that is open: its word as it stands. */
typedef struct row {
    int open, tested;
    char *word;
} row;

/* What the row claims beside its word is held to the word at once; the word to the intervals when
 * the row ends. */
static void begin_row(certificate *c, trace *r, row *open, const char *at, const char *end) {
    r->row = c->row_count;
    r->line = c->l.line;
    for (int k = 0; k < c->h.dimension; k++)
        if (!number_read(r->point[k], want(c, &at, end, "a coordinate")))
            fail(c, "a coordinate is not a number");
    word w = want(c, &at, end, "the word");
    if (w.length > MOST_WORD)
        give_up("%s:%zu: a word of more than %d letters", c->l.path, c->l.line, MOST_WORD);
    open->word = grow(open->word, w.length + 1, 1);
    memcpy(open->word, w.at, w.length);
    open->word[w.length] = '\0';
    if (strspn(open->word, "IBO") != w.length)
        fail(c, "the word is not of the letters I, B and O");
    verdict v = verdict_of(w, &c->h);
    char *claim = strtok(v.claims, ",");
    for (; claim; claim = strtok(NULL, ","))
        if (!word_is(want(c, &at, end, "a claim about the word"), claim))
            refute("%s:%zu: what is said of the word is not so; expected %s", c->l.path, c->l.line,
                   claim);
    if (!c->h.unsweep && read_count(c, &at, end, "k") != v.k)
        fail(c, "k is not that of the word");
    want_end(c, at, end);
    trace_start(r, (word){open->word, w.length});
}

static void end_row(certificate *c, trace *r, row *open, table *t) {
    if (!open->open)
        return;
    if (open->tested)
        trace_end(r);
    if (t)
        table_row(t, open->tested, (const mpq_t *)r->point, open->word);
    c->row_count++;
    open->open = 0;
}

static void read_interval(certificate *c, trace *r, word kind, const char *at, const char *end) {
    mpq_t to;
    poly q = {0};
    word w;
    mpq_init(to);
    if (!number_read(to, want(c, &at, end, "a time")))
        fail(c, "a time is not a number");
    while (word_next(&w, &at, end)) {
        if (q.n > MOST_DEGREE)
            give_up("%s:%zu: a polynomial of degree above %d", c->l.path, c->l.line, MOST_DEGREE);
        poly_extend(&q, q.n + 1);
        if (!integer_read(q.c[q.n - 1], w))
            fail(c, "a coefficient is not an integer");
    }
    int given = q.n > 0;
    poly_trim(&q);
    poly_make_primitive(&q);
    r->line = c->l.line;
    trace_interval(r, kind, to, given ? &q : NULL);
    poly_clear(&q);
    mpq_clear(to);
}

/* `complete N` and nothing behind it. */
static void read_end(certificate *c, const char *at, const char *end) {
    word line;
    if (read_count(c, &at, end, "the number of rows") != c->row_count)
        fail(c, "the number of rows is another");
    want_end(c, at, end);
    if (lines_next(&c->l, &line))
        fail(c, "text follows 'complete'");
}

void certificate_follow(certificate *c, trace *r, table *t, size_t part, size_t parts) {
    word line;
    row open = {0, 0, NULL};
    int complete = 0;
    while (!complete && lines_next(&c->l, &line)) {
        const char *at = line.at, *end = at + line.length;
        word w = want(c, &at, end, "'row', 'complete' or an interval");
        complete = word_is(w, "complete");
        if (complete || word_is(w, "row"))
            end_row(c, r, &open, t);
        if (word_is(w, "row")) {
            open.open = 1;
            open.tested = c->row_count % parts == part;
            if (open.tested)
                begin_row(c, r, &open, at, end);
        } else if (complete) {
            read_end(c, at, end);
        } else if (!open.open) {
            fail(c, "expected 'row'");
        } else if (open.tested) {
            read_interval(c, r, w, at, end);
        }
    }
    if (!complete)
        fail(c, "the certificate ends without 'complete'");
    free(open.word);
}
