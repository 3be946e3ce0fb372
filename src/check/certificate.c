/* The grammar of certificates: proofs/certificate.md, section 1.
 * SPDX-License-Identifier: MIT
 */
#include "check.h"

#include <string.h>

static _Noreturn void fail(const certificate *c, const char *what) {
    refute("%s:%zu: %s", c->l.path, c->l.line, what);
}

static int next_line(certificate *c) {
    word line;
    int more = lines_next(&c->l, &line);
    c->line = (source){.at = line.at, .end = line.at + line.length, .marks = BLANKS};
    return more;
}

static word want(certificate *c, const char *what) {
    word w = token(&c->line);
    if (w.length == 0)
        refute("%s:%zu: %s is missing", c->l.path, c->l.line, what);
    return w;
}

static void want_end(certificate *c) {
    if (token(&c->line).length > 0)
        fail(c, "there is too much on the line");
}

static void want_number(mpq_t out, certificate *c, const char *what) {
    if (!number_read(out, want(c, what)))
        refute("%s:%zu: %s is not a number", c->l.path, c->l.line, what);
}

static size_t want_count(certificate *c, const char *what) {
    size_t out;
    if (!count_read(&out, want(c, what)))
        refute("%s:%zu: %s is not a count", c->l.path, c->l.line, what);
    return out;
}

/* Read the next line of the head; returns its first word. */
static word head_key(certificate *c) {
    if (!next_line(c))
        fail(c, "the certificate ends in its head");
    return want(c, "a key");
}

static void want_key(const certificate *c, word w, const char *key) {
    if (!word_is(w, key))
        refute("%s:%zu: expected '%s'", c->l.path, c->l.line, key);
}

static word head_value(certificate *c, const char *key) {
    want_key(c, head_key(c), key);
    word value = want(c, "a value");
    want_end(c);
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
    word w = head_key(&c);
    c.h.contacts = word_is(w, "contacts");
    if (c.h.contacts) {
        want_key(&c, want(&c, "a value"), "yes");
        want_end(&c);
        w = head_key(&c);
    }
    want_key(&c, w, "signs");
    w = token(&c.line);
    for (size_t room = 0; w.length > 0; w = token(&c.line)) {
        c.times = room_for(c.times, c.time_count, &room, sizeof *c.times);
        mpq_init(c.times[c.time_count]);
        if (!number_read(c.times[c.time_count++], w))
            fail(&c, "a time is not a number");
    }
    return c;
}

/* Begin a row. The row's other claims are compared with its word here; the word is compared with
 * the intervals, at the latest when the row ends. */
static void begin_row(certificate *c, trace *r) {
    r->row = c->row_count;
    r->line = c->l.line;
    for (int k = 0; k < c->h.dimension; k++)
        want_number(r->point[k], c, "a coordinate");
    word w = want(c, "the word");
    if (w.length > MOST_WORD)
        give_up("%s:%zu: a word of more than %d letters", c->l.path, c->l.line, MOST_WORD);
    trace_start(r, w);
    if (strspn(r->word, "IBO") != w.length)
        fail(c, "the word is not of the letters I, B and O");
    verdict v = verdict_of(r->word, &c->h);
    for (char *claim = strtok(v.claims, ","); claim; claim = strtok(NULL, ","))
        if (!word_is(want(c, "a claim about the word"), claim))
            refute("%s:%zu: what is said of the word is not so; expected %s", c->l.path, c->l.line,
                   claim);
    if (!c->h.unsweep && want_count(c, "k") != v.k)
        fail(c, "k is not that of the word");
    want_end(c);
}

/* Read the next line, which must claim the contact that was found, word by word. */
static void read_contact(certificate *c) {
    if (!next_line(c))
        fail(c, "the certificate ends before a contact");
    const char *text = c->contact.text;
    source found = {.at = text, .end = text + c->contact.length, .marks = BLANKS};
    for (word w = token(&found); w.length > 0; w = token(&found)) {
        word claim = token(&c->line);
        if (claim.length != w.length || memcmp(claim.at, w.at, w.length) != 0)
            refute("%s:%zu: '%.*s' of a contact; expected '%.*s'", c->l.path, c->l.line,
                   WORD(claim), WORD(w));
    }
    want_end(c);
    c->contact.length = 0;
}

/* Is the word a kind of interval? These are O, I, B; a B and an O or I, in either order; and a B
 * between two of O, I, B. */
static int is_kind(word w) {
    for (size_t k = 0; k < w.length; k++)
        if (w.at[k] != 'O' && w.at[k] != 'I' && w.at[k] != 'B')
            return 0;
    return w.length == 1 || (w.length == 2 && (w.at[0] == 'B') != (w.at[1] == 'B')) ||
           (w.length == 3 && w.at[1] == 'B');
}

static void read_interval(certificate *c, trace *r, word kind) {
    mpq_t to;
    poly q = {0};
    mpq_init(to);
    want_number(to, c, "a time");
    for (word w = token(&c->line); w.length > 0; w = token(&c->line)) {
        if (q.n > MOST_DEGREE)
            give_up("%s:%zu: a polynomial of degree above %d", c->l.path, c->l.line, MOST_DEGREE);
        poly_extend(&q, q.n + 1);
        if (!integer_read(q.c[q.n - 1], w))
            fail(c, "a coefficient is not an integer");
    }
    int given = q.n > 0;
    if (!is_kind(kind) || given != (kind.length == 3))
        fail(c, "an interval is of a kind that does not exist, or its polynomial is missing or too "
                "much");
    poly_trim(&q);
    poly_make_primitive(&q);
    r->line = c->l.line;
    trace_interval(r, kind, to, given ? &q : NULL);
    if (c->h.contacts && contact_follow(&c->contact, r, kind, &q))
        read_contact(c);
    poly_clear(&q);
    mpq_clear(to);
}

static word next_first(certificate *c) {
    if (!next_line(c))
        fail(c, "the certificate ends without 'complete'");
    return want(c, "'row', 'complete' or an interval");
}

/* Read a row and its intervals; returns the first word of the line that follows. */
static word follow_row(certificate *c, trace *r, table *t, int tested) {
    if (tested)
        begin_row(c, r);
    word w = next_first(c);
    for (; !word_is(w, "row") && !word_is(w, "complete"); w = next_first(c))
        if (tested)
            read_interval(c, r, w);
    if (tested)
        trace_end(r);
    if (t)
        table_row(t, tested ? r : NULL);
    c->row_count++;
    return w;
}

void certificate_follow(certificate *c, trace *r, table *t, size_t part, size_t parts) {
    word w = next_first(c);
    while (word_is(w, "row"))
        w = follow_row(c, r, t, c->row_count % parts == part);
    if (!word_is(w, "complete"))
        fail(c, "expected 'row'");
    size_t rows = want_count(c, "the number of rows");
    if (rows != c->row_count)
        refute("%s:%zu: 'complete' says %zu rows; the certificate has %zu", c->l.path, c->l.line,
               rows, c->row_count);
    want_end(c);
    if (next_line(c))
        fail(c, "text follows 'complete'");
}
