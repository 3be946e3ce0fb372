/* OFF and WKT, and the cutting of facets into simplices.
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>
#include "solid.h"

/* What a file says: positions, and cycles of them with the facet they belong to. */
typedef struct draft {
    int d;
    size_t count, room; /* of coordinates */
    mpq_t *x;
    const char *path, *at, *end;
    size_t line;
} draft;

static _Noreturn void fail(const draft *f, const char *what) {
    give_up("%s:%zu: %s", f->path, f->line, what);
}

static void add_number(draft *f, word w) {
    f->x = room_for(f->x, f->count, &f->room, sizeof *f->x);
    mpq_init(f->x[f->count]);
    if (!number_read(f->x[f->count++], w))
        give_up("%s:%zu: '%.*s' is not a number", f->path, f->line, WORD(w));
}

static void add_simplex(solid *s, size_t *room, const size_t *v, size_t facet) {
    s->simplex = room_for(s->simplex, s->count, room, sizeof *s->simplex);
    memset(&s->simplex[s->count], 0, sizeof *s->simplex);
    s->simplex[s->count].facet = facet;
    memcpy(s->simplex[s->count++].v, v, (size_t)s->d * sizeof *v);
}

/* Integer coordinates, and one number for each position. */
static const solid *sorted; /* what compare_vertices compares */

static int compare_vertices(const void *a, const void *b) {
    const mpz_t *p = (const mpz_t *)sorted->x + *(const size_t *)a * (size_t)sorted->d;
    const mpz_t *q = (const mpz_t *)sorted->x + *(const size_t *)b * (size_t)sorted->d;
    int order = 0;
    for (int i = 0; i < sorted->d && order == 0; i++)
        order = mpz_cmp(p[i], q[i]);
    return order;
}

static void make_positions(solid *s, const draft *f, size_t *number) {
    mpz_init_set_ui(s->scale, 1);
    for (size_t k = 0; k < f->count; k++)
        mpz_lcm(s->scale, s->scale, mpq_denref(f->x[k]));
    if (mpz_sizeinbase(s->scale, 2) > MOST_BITS)
        give_up("the coordinates' common denominator is past %d bits", MOST_BITS);
    s->vertex_count = f->count / (size_t)f->d;
    s->x = grow(NULL, f->count, sizeof *s->x);
    for (size_t k = 0; k < f->count; k++) {
        mpz_init(s->x[k]);
        mpz_divexact(s->x[k], s->scale, mpq_denref(f->x[k]));
        mpz_mul(s->x[k], s->x[k], mpq_numref(f->x[k]));
        mpq_clear(f->x[k]);
    }
    size_t *order = grow(NULL, s->vertex_count, sizeof *order);
    for (size_t v = 0; v < s->vertex_count; v++)
        order[v] = v;
    sorted = s;
    qsort(order, s->vertex_count, sizeof *order, compare_vertices);
    for (size_t v = 0; v < s->vertex_count; v++)
        number[order[v]] = v > 0 && compare_vertices(&order[v - 1], &order[v]) == 0
                               ? number[order[v - 1]]
                               : order[v];
    free(order);
    free(f->x);
}

/* ------------------------------------------------------------------------------- cutting facets */

/* A facet's corners seen along a coordinate in which its normal is not zero. */
typedef struct outline {
    const solid *s;
    size_t n, *v;
    int b, c, sign;
} outline;

static int turn(const outline *o, size_t p, size_t q, size_t r) {
    const mpz_t *x = (const mpz_t *)o->s->x;
    mpz_t u, v, sum;
    mpz_inits(u, v, sum, NULL);
    mpz_sub(u, x[3 * q + (size_t)o->b], x[3 * p + (size_t)o->b]);
    mpz_sub(v, x[3 * r + (size_t)o->c], x[3 * p + (size_t)o->c]);
    mpz_mul(sum, u, v);
    mpz_sub(u, x[3 * q + (size_t)o->c], x[3 * p + (size_t)o->c]);
    mpz_sub(v, x[3 * r + (size_t)o->b], x[3 * p + (size_t)o->b]);
    mpz_submul(sum, u, v);
    int out = o->sign * mpz_sgn(sum);
    mpz_clears(u, v, sum, NULL);
    return out;
}

/* Choose the axis by the outline's normal (Newell); 1 if all corners lie in one plane. */
static int look_along(outline *o, size_t facet) {
    int planar = 1;
    const mpz_t *x = (const mpz_t *)o->s->x;
    mpz_t n[3], sum, first;
    mpz_inits(n[0], n[1], n[2], sum, first, NULL);
    for (size_t k = 0; k < o->n; k++) {
        size_t p = 3 * o->v[k], q = 3 * o->v[(k + 1) % o->n];
        for (size_t i = 0; i < 3; i++) {
            size_t j = (i + 1) % 3, l = (i + 2) % 3;
            mpz_addmul(n[i], x[p + j], x[q + l]);
            mpz_submul(n[i], x[p + l], x[q + j]);
        }
    }
    int axis = 0;
    while (axis < 2 && mpz_sgn(n[axis]) == 0)
        axis++;
    if (mpz_sgn(n[axis]) == 0)
        refute("solid: facet %zu has no area", facet);
    o->b = (axis + 1) % 3;
    o->c = (axis + 2) % 3;
    o->sign = mpz_sgn(n[axis]);
    for (size_t k = 0; k < o->n; k++) {
        mpz_set_ui(sum, 0);
        for (size_t i = 0; i < 3; i++)
            mpz_addmul(sum, n[i], x[3 * o->v[k] + i]);
        planar = planar && (k == 0 || mpz_cmp(sum, first) == 0);
        mpz_set(first, sum);
    }
    mpz_clears(n[0], n[1], n[2], sum, first, NULL);
    return planar;
}

static int is_ear(const outline *o, size_t k) {
    size_t p = o->v[(k + o->n - 1) % o->n], q = o->v[k], r = o->v[(k + 1) % o->n];
    if (turn(o, p, q, r) <= 0)
        return 0;
    for (size_t i = 2; i + 1 < o->n; i++) {
        size_t x = o->v[(k + i) % o->n];
        if (turn(o, p, q, x) >= 0 && turn(o, q, r, x) >= 0 && turn(o, r, p, x) >= 0)
            return 0;
    }
    return 1;
}

/* Cut off the first ear of the list, again and again. That the triangles make up the facet follows
 * from the test of the whole solid. */
static void cut_ears(solid *s, size_t *room, outline o, size_t facet) {
    size_t *v = o.v;
    while (o.n >= 3) {
        size_t k = 0;
        while (k < o.n && !is_ear(&o, k))
            k++;
        if (k == o.n)
            give_up("facet %zu cannot be cut into triangles ear by ear", facet);
        size_t t[3] = {v[(k + o.n - 1) % o.n], v[k], v[(k + 1) % o.n]};
        add_simplex(s, room, t, facet);
        if (o.n-- == 3)
            break;
        memmove(v + k, v + k + 1, (o.n - k) * sizeof *v);
    }
}

static void cut_fan(solid *s, size_t *room, const size_t *v, size_t n, size_t facet) {
    for (size_t k = 1; k + 1 < n; k++) {
        size_t t[3] = {v[0], v[k], v[k + 1]};
        add_simplex(s, room, t, facet);
    }
}

/* --------------------------------------------------------------------------------------- OFF */

/* The next line that is not empty, without comment; 0 at the end. */
static int next_line(draft *f, word *out) {
    while (f->at < f->end) {
        const char *stop = memchr(f->at, '\n', (size_t)(f->end - f->at));
        const char *end = stop ? stop : f->end, *mark = memchr(f->at, '#', (size_t)(end - f->at));
        word line = {f->at, (size_t)((mark ? mark : end) - f->at)}, any;
        if (line.length > 0 && line.at[line.length - 1] == '\r')
            line.length--;
        f->at = stop ? stop + 1 : f->end;
        f->line++;
        const char *at = line.at;
        *out = line;
        if (word_next(&any, &at, line.at + line.length))
            return 1;
    }
    return 0;
}

static void cut_facet(solid *s, size_t *room, size_t *v, size_t n, size_t facet, int triangulate) {
    outline o = {s, n, v, 0, 0, 0};
    int planar = n == 3 || look_along(&o, facet);
    if (!planar && !triangulate)
        refute("solid: facet %zu is not planar", facet);
    if (n > 3 && planar)
        cut_ears(s, room, o, facet);
    else
        cut_fan(s, room, v, n, facet);
}

/* Leave out corners at the position of the one before; returns how many are left. */
static size_t without_repeats(size_t *v, size_t n) {
    size_t kept = 0;
    for (size_t k = 0; k < n; k++)
        /* cppcheck-suppress uninitvar ; cppcheck thinks of n = 0, where nothing is read */
        if (v[k] != v[(k + n - 1) % n])
            v[kept++] = v[k];
    return kept;
}

static void read_off_facet(solid *s, size_t *room, draft *f, const size_t *number, size_t vertices,
                           size_t facet, int triangulate) {
    word line, w;
    size_t n, v[MOST_CORNERS];
    if (!next_line(f, &line))
        fail(f, "a facet is missing");
    const char *at = line.at, *end = line.at + line.length;
    if (!word_next(&w, &at, end) || !count_read(&n, w) || n < 3 || n > MOST_CORNERS)
        fail(f, "a facet begins with its number of corners");
    for (size_t k = 0; k < n; k++) {
        if (!word_next(&w, &at, end) || !count_read(&v[k], w) || v[k] >= vertices)
            fail(f, "a corner is not the number of a vertex");
        v[k] = number[v[k]];
    }
    size_t colours = 0;
    mpq_t colour;
    mpq_init(colour);
    for (; word_next(&w, &at, end); colours++)
        if (!number_read(colour, w))
            fail(f, "what follows a facet's corners is no colour");
    mpq_clear(colour);
    if (colours == 2 || colours > 4)
        fail(f, "a colour has 1, 3 or 4 numbers");
    n = n > 3 ? without_repeats(v, n) : n;
    if (n < 3)
        refute("solid: facet %zu has no area", facet);
    cut_facet(s, room, v, n, facet, triangulate);
}

static void read_off(solid *s, draft *f, int triangulate) {
    word line, w;
    size_t counts[3] = {0, 0, 0}, have = 0, room = 0;
    const char *at, *end;
    if (!next_line(f, &line))
        fail(f, "OFF is expected");
    at = line.at, end = line.at + line.length;
    if (!word_next(&w, &at, end) || !word_is(w, "OFF"))
        fail(f, "OFF is expected");
    for (; have < 3; have++) {
        while (!word_next(&w, &at, end)) {
            if (!next_line(f, &line))
                fail(f, "three counts are expected");
            at = line.at, end = line.at + line.length;
        }
        if (!count_read(&counts[have], w))
            fail(f, "three counts are expected");
    }
    for (size_t v = 0; v < counts[0]; v++) {
        if (!next_line(f, &line))
            fail(f, "a vertex is missing");
        at = line.at, end = line.at + line.length;
        for (int k = 0; k < 3; k++)
            if (word_next(&w, &at, end))
                add_number(f, w);
        if (f->count != 3 * (v + 1) || word_next(&w, &at, end))
            fail(f, "a vertex has three numbers");
    }
    size_t *number = grow(NULL, counts[0], sizeof *number);
    make_positions(s, f, number);
    for (size_t k = 0; k < counts[1]; k++)
        read_off_facet(s, &room, f, number, counts[0], k, triangulate);
    if (next_line(f, &line))
        fail(f, "text follows the last facet");
    free(number);
}

/* --------------------------------------------------------------------------------------- WKT */

static word wkt_word(draft *f) {
    while (f->at < f->end && *f->at && strchr(" \t\r\n", *f->at))
        f->line += *f->at++ == '\n';
    word out = {f->at, 0};
    if (f->at < f->end && *f->at && strchr("(),", *f->at))
        out.length = 1;
    else
        while (f->at + out.length < f->end && f->at[out.length] &&
               !strchr("(), \t\r\n", f->at[out.length]))
            out.length++;
    f->at += out.length;
    return out;
}

static void want(draft *f, const char *what) {
    if (!word_is(wkt_word(f), what))
        give_up("%s:%zu: '%s' is expected", f->path, f->line, what);
}

/* 1 after a comma, 0 after a closing bracket. */
static int goes_on(draft *f) {
    word w = wkt_word(f);
    if (!word_is(w, ",") && !word_is(w, ")"))
        fail(f, "',' or ')' is expected");
    return *w.at == ',';
}

/* Twice the area of positions [first, end), which are closed: the last is the first. */
static int ring_sign(const draft *f, size_t first, size_t end) {
    mpq_t sum, term;
    mpq_inits(sum, term, NULL);
    for (size_t k = first; k + 1 < end; k++) {
        mpq_mul(term, f->x[2 * k], f->x[2 * k + 3]);
        mpq_add(sum, sum, term);
        mpq_mul(term, f->x[2 * k + 1], f->x[2 * k + 2]);
        mpq_sub(sum, sum, term);
    }
    int sign = mpq_sgn(sum);
    mpq_clears(sum, term, NULL);
    return sign;
}

static void read_ring(solid *s, size_t *room, draft *f, int outer, size_t polygon) {
    size_t first = f->count / 2;
    want(f, "(");
    do {
        add_number(f, wkt_word(f));
        add_number(f, wkt_word(f));
    } while (goes_on(f));
    size_t end = f->count / 2;
    if (end - first < 4 || !mpq_equal(f->x[2 * first], f->x[f->count - 2]) ||
        !mpq_equal(f->x[2 * first + 1], f->x[f->count - 1]))
        fail(f, "a ring has at least four positions, the last one its first");
    int sign = ring_sign(f, first, end);
    if (sign == 0)
        refute("solid: a ring of polygon %zu has no area", polygon);
    for (size_t k = first; k + 1 < end; k++) {
        if (mpq_equal(f->x[2 * k], f->x[2 * k + 2]) && mpq_equal(f->x[2 * k + 1], f->x[2 * k + 3]))
            continue; /* a side without length */
        int ahead = (sign > 0) == outer;
        size_t v[3] = {ahead ? k : k + 1, ahead ? k + 1 : k, 0};
        add_simplex(s, room, v, polygon);
    }
}

static void read_polygon(solid *s, size_t *room, draft *f, size_t polygon) {
    int outer = 1;
    want(f, "(");
    do {
        read_ring(s, room, f, outer, polygon);
        outer = 0;
    } while (goes_on(f));
}

static void read_wkt(solid *s, draft *f) {
    size_t room = 0, polygon = 0;
    word w = wkt_word(f);
    if (word_is(w, "POLYGON")) {
        read_polygon(s, &room, f, 0);
    } else if (word_is(w, "MULTIPOLYGON")) {
        want(f, "(");
        do
            read_polygon(s, &room, f, polygon++);
        while (goes_on(f));
    } else
        fail(f, "POLYGON or MULTIPOLYGON is expected");
    if (wkt_word(f).length > 0 || f->at != f->end)
        fail(f, "text follows the last ')'");
    size_t *number = grow(NULL, f->count / 2, sizeof *number);
    make_positions(s, f, number);
    for (size_t k = 0; k < s->count; k++)
        for (int i = 0; i < 2; i++)
            s->simplex[k].v[i] = number[s->simplex[k].v[i]];
    free(number);
}

solid solid_read(const char *path, const char *text, size_t length, int triangulate) {
    solid s = {.d = 0};
    draft f = {.path = path, .at = text, .end = text + length, .line = 1};
    size_t n = strlen(path);
    if (length >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0)
        f.at += 3;
    if (n > 4 && strcmp(path + n - 4, ".off") == 0) {
        f.d = s.d = 3;
        f.line = 0;
        read_off(&s, &f, triangulate);
    } else if (n > 4 && strcmp(path + n - 4, ".wkt") == 0) {
        f.d = s.d = 2;
        read_wkt(&s, &f);
    } else
        give_up("%s: a solid in .off or .wkt is expected", path);
    solid_finish(&s);
    return s;
}
