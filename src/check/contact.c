/* Contacts of a row: their times and cells, as the lines of a certificate say them.
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>
#include "check.h"

/* A face a; an edge a < b; a vertex a. */
typedef struct cell {
    enum { FACE, EDGE, VERTEX } kind;
    size_t a, b;
} cell;

static void put(contact *c, const char *text, size_t length) {
    for (size_t k = 0; k < length; k++) {
        c->text = room_for(c->text, c->length, &c->room, 1);
        c->text[c->length++] = text[k];
    }
}

static void put_number(contact *c, mpq_srcptr x) {
    char *text = mpq_get_str(NULL, 10, x);
    put(c, " ", 1);
    put(c, text, strlen(text));
    free(text);
}

/* The root of q in the last interval: a number if q is linear. */
static void put_root(contact *c, const trace *r, const poly *q) {
    mpq_t x;
    mpq_init(x);
    if (q->n == 2) {
        mpq_set_num(x, q->c[0]);
        mpq_set_den(x, q->c[1]);
        mpq_canonicalize(x);
        mpq_neg(x, x);
        put_number(c, x);
    } else {
        put(c, " root", 5);
        put_number(c, r->from);
        put_number(c, r->at);
        for (size_t k = 0; k < q->n; k++) {
            mpq_set_z(x, q->c[k]);
            put_number(c, x);
        }
    }
    mpq_clear(x);
}

/* The cell of a simplex at which just the side forms with a bit in `zero` are zero. */
static cell cell_of(const solid *s, size_t simplex, unsigned zero) {
    const struct simplex *f = &s->simplex[simplex];
    size_t n = 0, v[3] = {0, 0, 0};
    for (int i = 0; i < s->d; i++) {
        unsigned sides = 1u << i; /* that end in vertex i */
        if (s->d == 3)
            sides |= 1u << (i + 2) % 3;
        if ((zero & ~sides) == 0)
            v[n++] = f->v[i];
    }
    if (n == 3 || (n == 2 && (zero & f->diagonals)))
        return (cell){FACE, f->facet, 0};
    if (n == 2)
        return v[0] < v[1] ? (cell){EDGE, v[0], v[1]} : (cell){EDGE, v[1], v[0]};
    return (cell){VERTEX, v[0], 0};
}

static int compare_cells(const void *x, const void *y) {
    const cell *p = x, *q = y;
    int order = (p->kind > q->kind) - (p->kind < q->kind);
    if (order == 0)
        order = (p->a > q->a) - (p->a < q->a);
    return order != 0 ? order : (p->b > q->b) - (p->b < q->b);
}

/* The cells met, some twice; in the plane with all vertices of a ring that follow one another at a
 * position. */
static cell *cells_met(size_t *count, const trace *r) {
    size_t room = 0;
    cell *all = NULL;
    *count = 0;
    for (size_t k = 0; k < r->met.count; k++) {
        cell next = cell_of(r->s, r->met.item[k] / 8, r->met.item[k] % 8);
        for (int more = 1; more;) {
            all = room_for(all, *count, &room, sizeof *all);
            all[(*count)++] = next;
            more = next.kind == VERTEX && r->s->d == 2 && r->s->twin[next.a] != next.a;
            next.a = more ? r->s->twin[next.a] : next.a;
        }
    }
    return all;
}

static void put_cells(contact *c, trace *r) {
    static const char *const name[] = {" face ", " edge ", " vertex "};
    size_t count;
    cell *all = cells_met(&count, r);
    char text[80]; /* a number has at most 20 digits */
    qsort(all, count, sizeof *all, compare_cells);
    for (size_t k = 0, next; k < count; k = next) {
        for (next = k + 1; next < count && compare_cells(&all[next], &all[k]) == 0; next++)
            ;
        snprintf(text, sizeof text, all[k].kind == EDGE ? "%s%zu-%zu" : "%s%zu", name[all[k].kind],
                 all[k].a, all[k].b);
        put(c, text, strlen(text));
    }
    free(all);
    trace_forget_cells(r);
}

/* The root of the last interval, or where its state begins to be B, or ends: one of its ends. */
static void put_time(contact *c, const trace *r, const poly *q, int at_root, mpq_srcptr end) {
    if (at_root)
        put_root(c, r, q);
    else
        put_number(c, end);
}

int contact_follow(contact *c, trace *r, word kind, const poly *q) {
    static const char name[] = "contact", to[] = " to";
    size_t begin = strlen(name), mid;
    char first = kind.at[0], last = kind.at[kind.length - 1];
    int at_root = kind.length == 3;
    if (kind.length == 1 && last != 'B')
        return 0;
    if (c->length == 0) {
        put(c, name, begin);
        put_time(c, r, q, at_root && first != 'B', first == 'B' ? r->from : r->at);
    }
    if (last == 'B' && mpq_cmp(r->at, r->m->piece[r->m->count - 1].hi) != 0)
        return 0;
    mid = c->length;
    put(c, to, strlen(to));
    put_time(c, r, q, at_root && last != 'B', last == 'B' ? r->at : r->from);
    size_t length = c->length - mid - strlen(to);
    if (length == mid - begin && memcmp(c->text + begin, c->text + c->length - length, length) == 0)
        c->length = mid;
    put_cells(c, r);
    return 1;
}
