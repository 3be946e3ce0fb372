/* Compares a golden table with the certified rows.
 * SPDX-License-Identifier: MIT
 */
#include <string.h>
#include "check.h"

static _Noreturn void differs(const table *t, const char *what) {
    refute("%s:%zu: the table differs from the certificate in %s", t->l.path, t->l.line, what);
}

enum { KEYS = 9 };

/* Compare a line `# KEY VALUE` with the certificate if KEY is one of these keys; bit k of `seen` is
 * set for key k. */
static void check_line(const table *t, word line, unsigned *seen) {
    const head *h = t->h;
    const char *const keys[KEYS][2] = {{"contract", "1"},
                                       {"dimension", h->dimension == 2 ? "2" : "3"},
                                       {"solid-sha256", h->solid},
                                       {"motion-sha256", h->motion},
                                       {"scene-sha256", h->scene},
                                       {"operation", h->unsweep ? "unsweep" : "sweep"},
                                       {"folds", h->combined ? "combined" : "separate"},
                                       {"round", "none"},
                                       {"triangulate", "no"}};
    (void)word_take(&line, "#");
    source f = {.at = line.at, .end = line.at + line.length, .marks = BLANKS};
    word key = token(&f), value = token(&f);
    for (int k = 0; k < KEYS; k++) {
        if (!word_is(key, keys[k][0]))
            continue;
        if (!word_is(value, keys[k][1]))
            differs(t, keys[k][0]);
        *seen |= 1u << k;
    }
}

static word next_cell(word *rest) {
    word out = word_cut(rest, ",");
    (void)word_take(rest, ",");
    return out;
}

/* Read the next cells of a row; are they the expected ones, which are separated by commas? */
static int cells_are(word *rest, const char *expected) {
    word cells = word_of(expected);
    int same = 1;
    while (same && cells.length > 0) {
        word want = next_cell(&cells), cell = next_cell(rest);
        same = want.length == cell.length && memcmp(want.at, cell.at, cell.length) == 0;
    }
    return same;
}

/* Refute the table unless the certified columns come first; the note names all others. */
static void check_columns(const table *t, word rest, int tells) {
    if (!cells_are(&rest, t->h->dimension == 2 ? "x,y" : "x,y,z") ||
        !cells_are(&rest, t->h->unsweep ? "pmc,word" : "pmc,class,definition,case,i,t,word"))
        differs(t, "its columns");
    if (tells && rest.length > 0)
        fprintf(stderr, "graze-check: note: columns that are not certified: %.*s\n",
                (int)rest.length, rest.at);
}

table table_open(const char *path, const head *h, int tells) {
    table t = {lines_open(path), h, 0};
    word line;
    unsigned seen = 0;
    while (lines_next(&t.l, &line)) {
        if (line.length == 0 || *line.at != '#') {
            if (seen != (1u << KEYS) - 1)
                differs(&t, "its head, of which lines are missing");
            check_columns(&t, line, tells);
            return t;
        }
        check_line(&t, line, &seen);
    }
    refute("%s: the table has no rows", path);
}

static void check_row(const table *t, word rest, const trace *r) {
    verdict v = verdict_of(r->word, t->h);
    mpq_t x;
    mpq_init(x);
    for (int k = 0; k < t->h->dimension; k++)
        if (!number_read(x, next_cell(&rest)) || !mpq_equal(x, r->point[k]))
            differs(t, "the point");
    mpq_clear(x);
    if (!cells_are(&rest, v.claims))
        refute("%s:%zu: the table differs from the certificate; expected %s", t->l.path, t->l.line,
               v.claims);
    if (!cells_are(&rest, r->word))
        differs(t, "the word");
    int quoted = 0;
    for (size_t k = 0; k < rest.length; k++)
        quoted ^= rest.at[k] == '"';
    if (quoted)
        give_up("%s:%zu: a cell with a line break", t->l.path, t->l.line);
}

void table_row(table *t, const trace *r) {
    word line;
    lines_next(&t->l, &line); /* empty at the end */
    if (line.length == 0 || *line.at == '#')
        refute("%s:%zu: the table has fewer rows than the certificate", t->l.path, t->l.line);
    if (r)
        check_row(t, line, r);
    t->rows++;
}

/* Is this the line with the number of undecided positions, which the column topo adds? */
static int is_undecided_line(word line) {
    static const char key[] = "# undecided ";
    return line.length >= sizeof key && memcmp(line.at, key, sizeof key - 1) == 0;
}

void table_end(table *t) {
    char expected[60];
    word line;
    snprintf(expected, sizeof expected, "# complete %zu", t->rows);
    lines_next(&t->l, &line); /* empty at the end */
    if (is_undecided_line(line))
        lines_next(&t->l, &line);
    if (!word_is(line, expected) || lines_next(&t->l, &line))
        refute("%s:%zu: the table does not end with '%s'", t->l.path, t->l.line, expected);
}
