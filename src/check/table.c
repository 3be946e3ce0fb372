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

/* A line `# KEY VALUE`: is it held to the certificate? */
static void check_head(const table *t, const char *key, word value, const char *line_key,
                       size_t *seen, size_t bit, const char *expected) {
    if (strcmp(key, line_key) != 0)
        return;
    if (!word_is(value, expected))
        differs(t, key);
    *seen |= bit;
}

static void check_line(const table *t, word line, size_t *seen) {
    const head *h = t->h;
    const char *at = line.at, *end = at + line.length;
    word mark, key, value;
    char name[32] = "";
    if (!word_next(&mark, &at, end) || !word_next(&key, &at, end) || key.length >= sizeof name)
        return;
    (void)word_next(&value, &at, end);
    memcpy(name, key.at, key.length);
    check_head(t, "contract", value, name, seen, 1, "1");
    check_head(t, "dimension", value, name, seen, 2, h->dimension == 2 ? "2" : "3");
    check_head(t, "solid-sha256", value, name, seen, 4, h->solid);
    check_head(t, "motion-sha256", value, name, seen, 8, h->motion);
    check_head(t, "scene-sha256", value, name, seen, 16, h->scene);
    check_head(t, "operation", value, name, seen, 32, h->unsweep ? "unsweep" : "sweep");
    check_head(t, "folds", value, name, seen, 64, h->combined ? "combined" : "separate");
    check_head(t, "round", value, name, seen, 128, "none");
    check_head(t, "triangulate", value, name, seen, 256, h->triangulate ? "yes" : "no");
}

/* The next cell of a row, up to a comma or the end. */
static word next_cell(const char **at, const char *end) {
    word out = {*at, 0};
    while (*at < end && **at != ',')
        ++*at;
    out.length = (size_t)(*at - out.at);
    *at += *at < end;
    return out;
}

static void check_columns(const table *t, word line) {
    static const char *const sweep[] = {"pmc", "class", "definition", "case", "i", "t", "word", 0};
    static const char *const unsweep[] = {"pmc", "word", 0};
    static const char *const names[] = {"x", "y", "z"};
    const char *at = line.at, *end = at + line.length;
    for (int k = 0; k < t->h->dimension; k++)
        if (!word_is(next_cell(&at, end), names[k]))
            differs(t, "its columns");
    for (const char *const *want = t->h->unsweep ? unsweep : sweep; *want; want++)
        if (!word_is(next_cell(&at, end), *want))
            differs(t, "its columns");
    while (at < end) {
        word w = next_cell(&at, end);
        if (word_is(w, "topo") || word_is(w, "sdf"))
            fprintf(stderr, "graze-check: note: column %.*s is not certified\n", WORD(w));
    }
}

table table_open(const char *path, const head *h) {
    table t = {lines_open(path), h, 0};
    word line;
    size_t seen = 0;
    while (lines_next(&t.l, &line)) {
        if (line.length == 0 || *line.at != '#') {
            if (seen != 511)
                differs(&t, "its head, of which lines are missing");
            check_columns(&t, line);
            return t;
        }
        check_line(&t, line, &seen);
    }
    refute("%s: the table has no rows", path);
}

static void check_cell(const table *t, word w, const char *expected, const char *name) {
    if (!word_is(w, expected))
        differs(t, name);
}

static void check_count(const table *t, word w, unsigned long expected, const char *name) {
    size_t value;
    if (!count_read(&value, w) || value != expected)
        differs(t, name);
}

void table_row(table *t, const mpq_t *point, const char *states, const verdict *v) {
    word line;
    mpq_t x;
    mpq_init(x);
    if (!lines_next(&t->l, &line) || line.length == 0 || *line.at == '#')
        refute("%s:%zu: the table has fewer rows than the certificate", t->l.path, t->l.line);
    const char *at = line.at, *end = at + line.length;
    for (int k = 0; k < t->h->dimension; k++)
        if (!number_read(x, next_cell(&at, end)) || !mpq_equal(x, point[k]))
            differs(t, "the point");
    check_cell(t, next_cell(&at, end), v->pmc, "pmc");
    if (!t->h->unsweep) {
        check_cell(t, next_cell(&at, end), v->class_, "class");
        check_cell(t, next_cell(&at, end), v->definition, "definition");
        check_count(t, next_cell(&at, end), (unsigned long)v->position, "case");
        check_count(t, next_cell(&at, end), v->i, "i");
        check_count(t, next_cell(&at, end), v->t, "t");
    }
    check_cell(t, next_cell(&at, end), states, "the word");
    size_t quotes = 0;
    for (; at < end; at++)
        quotes += *at == '"';
    if (quotes % 2 != 0)
        give_up("%s:%zu: a cell with a line break", t->l.path, t->l.line);
    t->rows++;
    mpq_clear(x);
}

void table_end(table *t) {
    word line, mark, name, count;
    size_t rows;
    if (!lines_next(&t->l, &line))
        refute("%s: the table is not complete", t->l.path);
    const char *at = line.at, *end = at + line.length;
    if (!word_next(&mark, &at, end) || !word_is(mark, "#") || !word_next(&name, &at, end) ||
        !word_is(name, "complete") || !word_next(&count, &at, end) || !count_read(&rows, count) ||
        rows != t->rows || lines_next(&t->l, &line))
        refute("%s:%zu: the table does not end with the number of its rows", t->l.path, t->l.line);
}
