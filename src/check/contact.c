/* Contacts of a row: writes their times and cells as a certificate's lines do.
 * SPDX-License-Identifier: MIT
 */
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include "check.h"

/* A cell: {FACE, a}, {EDGE, a, b} with the vertices a < b, or {VERTEX, a}. */
typedef struct cell {
    size_t part[3];
} cell;

enum { FACE, EDGE, VERTEX };

static void put(contact *c, const char *format, ...) {
    char *text;
    va_list arguments;
    va_start(arguments, format);
    size_t length = (size_t)gmp_vasprintf(&text, format, arguments);
    va_end(arguments);
    c->text = room_for(c->text, c->length + length, &c->room, 1);
    memcpy(c->text + c->length, text, length);
    c->length += length;
    free(text);
}

/* Write a time: if `at_root` the root of q in the last interval, as a number if q is linear; else
 * `end`. */
static void put_time(contact *c, const trace *r, const poly *q, int at_root, mpq_srcptr end) {
    mpq_t x;
    mpq_init(x);
    if (!at_root) {
        put(c, " %Qd", end);
    } else if (q->n == 2) {
        mpz_neg(mpq_numref(x), q->c[0]);
        mpz_set(mpq_denref(x), q->c[1]);
        mpq_canonicalize(x);
        put(c, " %Qd", x);
    } else {
        put(c, " root %Qd %Qd", r->from, r->at);
        for (size_t k = 0; k < q->n; k++)
            put(c, " %Zd", q->c[k]);
    }
    mpq_clear(x);
}

/* The cell of a simplex on which exactly the side forms with a bit in `zero` are zero. */
static cell cell_of(const solid *s, size_t simplex, unsigned zero) {
    const struct simplex *f = &s->simplex[simplex];
    size_t n = 0, v[3] = {0, 0, 0};
    for (int i = 0; i < s->d; i++) {
        unsigned sides = 1u << i; /* the sides that end in vertex i */
        if (s->d == 3)
            sides |= 1u << (i + 2) % 3;
        if ((zero & ~sides) == 0)
            v[n++] = f->v[i];
    }
    if (n == 3 || (n == 2 && (zero & f->diagonals)))
        return (cell){{FACE, f->facet, 0}};
    if (n == 2)
        return (cell){{EDGE, v[v[0] > v[1]], v[v[0] < v[1]]}};
    return (cell){{VERTEX, v[0], 0}};
}

static int compare_cells(const void *x, const void *y) {
    const cell *p = x, *q = y;
    int order = 0;
    for (int k = 0; k < 3 && order == 0; k++)
        order = (p->part[k] > q->part[k]) - (p->part[k] < q->part[k]);
    return order;
}

/* Write the cells met, each once, and empty the trace's list of them. In the plane a vertex stands
 * with all vertices of its ring that follow one another at the same position. */
static void put_cells(contact *c, trace *r) {
    static const char *const format[] = {" face %zu", " edge %zu-%zu", " vertex %zu"};
    size_t count = 0, room = 0;
    cell *all = room_for(NULL, 0, &room, sizeof *all);
    for (size_t k = 0; k < r->met.count; k++) {
        cell next = cell_of(r->s, r->met.item[k] / 8, r->met.item[k] % 8);
        size_t before, twins = r->s->d == 2 && next.part[0] == VERTEX;
        r->is_met[r->met.item[k] / 8] = 0;
        do {
            all = room_for(all, count, &room, sizeof *all);
            all[count++] = next;
            before = next.part[1];
            next.part[1] = twins ? r->s->twin[before] : before;
        } while (next.part[1] != before);
    }
    r->met.count = 0;
    qsort(all, count, sizeof *all, compare_cells);
    for (size_t k = 0; k < count; k++)
        if (k == 0 || compare_cells(&all[k], &all[k - 1]) != 0)
            put(c, format[all[k].part[0]], all[k].part[1], all[k].part[2]);
    free(all);
}

int contact_follow(contact *c, trace *r, word kind, const poly *q) {
    static const char name[] = "contact";
    char first = kind.at[0], last = kind.at[kind.length - 1];
    int at_root = kind.length == 3;
    if (kind.length == 1 && last != 'B')
        return 0;
    if (c->length == 0) {
        put(c, name);
        put_time(c, r, q, at_root && first != 'B', first == 'B' ? r->from : r->at);
    }
    if (last == 'B' && mpq_cmp(r->at, r->m->piece[r->m->count - 1].hi) != 0)
        return 0;
    size_t begin = strlen(name), length = c->length - begin;
    put(c, " to");
    size_t end = c->length;
    put_time(c, r, q, at_root && last != 'B', last == 'B' ? r->at : r->from);
    if (c->length - end == length && memcmp(c->text + begin, c->text + end, length) == 0)
        c->length = begin + length; /* both times have the same text, so it is written once */
    put_cells(c, r);
    return 1;
}
