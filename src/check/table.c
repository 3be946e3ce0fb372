/* Lines of files, and a golden table held to what was certified.
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>
#include "rows.h"

lines lines_open(const char *path) {
    lines l = {.path = path, .file = fopen(path, "rb")};
    if (!l.file)
        give_up("%s: cannot be opened", path);
    return l;
}

int lines_next(lines *l, word *out) {
    size_t n = 0;
    int c;
    while ((c = getc(l->file)) != EOF && c != '\n') {
        if (n >= MOST_LINE)
            give_up("%s:%zu: a line of more than %d bytes", l->path, l->line + 1, MOST_LINE);
        l->text = room_for(l->text, n + 1, &l->room, 1);
        l->text[n++] = (char)c;
    }
    if (ferror(l->file))
        give_up("%s: cannot be read", l->path);
    l->line += n > 0 || c != EOF;
    *out = (word){n > 0 ? l->text : "", n};
    return n > 0 || c != EOF;
}

static _Noreturn void differs(const table *t, const char *what) {
    refute("%s:%zu: the table differs from the certificate in %s", t->l.path, t->l.line, what);
}

enum { KEYS = 9 };

/* A line `# KEY VALUE` is held to the certificate if its key is one of these; `seen` has a bit for
 * each. */
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
    const char *at = line.at, *end = at + line.length;
    word mark, key, value;
    (void)word_next(&mark, &at, end);
    (void)word_next(&key, &at, end);
    (void)word_next(&value, &at, end);
    for (int k = 0; k < KEYS; k++) {
        if (!word_is(key, keys[k][0]))
            continue;
        if (!word_is(value, keys[k][1]))
            differs(t, keys[k][0]);
        *seen |= 1u << k;
    }
}

/* What stands before the next comma. */
static word next_cell(word *rest) {
    word out = {rest->at, 0};
    while (out.length < rest->length && out.at[out.length] != ',')
        out.length++;
    word_skip(rest, out.length);
    (void)word_take(rest, ",");
    return out;
}

/* The next cells are these, and a cell ends behind them. */
static int cells_are(word *rest, const char *expected) {
    size_t n = strlen(expected);
    int same = rest->length >= n && memcmp(rest->at, expected, n) == 0 &&
               (rest->length == n || rest->at[n] == ',');
    if (same)
        word_skip(rest, n + (rest->length > n));
    return same;
}

static void check_columns(const table *t, word rest) {
    if (!cells_are(&rest, t->h->dimension == 2 ? "x,y" : "x,y,z") ||
        !cells_are(&rest, t->h->unsweep ? "pmc,word" : "pmc,class,definition,case,i,t,word"))
        differs(t, "its columns");
    while (rest.length > 0) {
        word w = next_cell(&rest);
        if (word_is(w, "topo") || word_is(w, "sdf"))
            fprintf(stderr, "graze-check: note: column %.*s is not certified\n", WORD(w));
    }
}

table table_open(const char *path, const head *h) {
    table t = {lines_open(path), h, 0};
    word line;
    unsigned seen = 0;
    while (lines_next(&t.l, &line)) {
        if (line.length == 0 || *line.at != '#') {
            if (seen != (1u << KEYS) - 1)
                differs(&t, "its head, of which lines are missing");
            check_columns(&t, line);
            return t;
        }
        check_line(&t, line, &seen);
    }
    refute("%s: the table has no rows", path);
}

static void check_row(const table *t, word rest, const mpq_t *point, const char *states) {
    verdict v = verdict_of((word){states, strlen(states)}, t->h);
    mpq_t x;
    mpq_init(x);
    for (int k = 0; k < t->h->dimension; k++)
        if (!number_read(x, next_cell(&rest)) || !mpq_equal(x, point[k]))
            differs(t, "the point");
    mpq_clear(x);
    if (!cells_are(&rest, v.claims))
        refute("%s:%zu: the table differs from the certificate; expected %s", t->l.path, t->l.line,
               v.claims);
    if (!cells_are(&rest, states))
        differs(t, "the word");
    size_t quotes = 0;
    for (size_t k = 0; k < rest.length; k++)
        quotes += rest.at[k] == '"';
    if (quotes % 2 != 0)
        give_up("%s:%zu: a cell with a line break", t->l.path, t->l.line);
}

void table_row(table *t, int held, const mpq_t *point, const char *states) {
    word line;
    if (!lines_next(&t->l, &line) || line.length == 0 || *line.at == '#')
        refute("%s:%zu: the table has fewer rows than the certificate", t->l.path, t->l.line);
    if (held)
        check_row(t, line, point, states);
    t->rows++;
}

void table_end(table *t) {
    word line, mark, name, count, more;
    size_t rows;
    if (!lines_next(&t->l, &line))
        refute("%s: the table is not complete", t->l.path);
    const char *at = line.at, *end = at + line.length;
    if (!word_next(&mark, &at, end) || !word_is(mark, "#") || !word_next(&name, &at, end) ||
        !word_is(name, "complete") || !word_next(&count, &at, end) || !count_read(&rows, count) ||
        rows != t->rows || word_next(&more, &at, end) || lines_next(&t->l, &line))
        refute("%s:%zu: the table does not end with the number of its rows", t->l.path, t->l.line);
}
