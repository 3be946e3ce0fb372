/* Reads OFF and WKT; a facet of more than three corners becomes the fan of its first corner.
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>
#include "solid.h"

/* Bits of all coordinates as integers: 2^33, 1 GB; where addresses have 32 bits 2^31. */
static const size_t MOST_SCALED = (size_t)1 << (29 + sizeof(size_t) / 2);

/* The coordinates read from a file so far. */
typedef struct draft {
    source f;
    size_t count, room; /* of coordinates */
    mpq_t *x;
} draft;

/* Count the work of a sum or a product of a and b, which follows. */
static void work_on_fractions(mpq_srcptr a, mpq_srcptr b) {
    work_on(mpq_numref(a), mpq_numref(b));
    work_on(mpq_numref(a), mpq_denref(b));
    work_on(mpq_denref(a), mpq_numref(b));
    work_on(mpq_denref(a), mpq_denref(b));
}

static void add_number(draft *in, word w) {
    in->x = room_for(in->x, in->count, &in->room, sizeof *in->x);
    mpq_init(in->x[in->count]);
    if (!number_read(in->x[in->count++], w))
        give_up("%s:%zu: '%.*s' is not a number", in->f.path, in->f.line, WORD(w));
}

static void add_simplex(solid *s, size_t a, size_t b, size_t c, size_t facet) {
    s->simplex = room_for(s->simplex, s->count, &s->room, sizeof *s->simplex);
    s->simplex[s->count++] = (simplex){.v = {a, b, c}, .facet = facet};
}

/* Make integers of the coordinates, with a 1 behind those of each vertex. */
static void take_positions(solid *s, draft *in) {
    size_t d = (size_t)s->d;
    mpz_init_set_ui(s->scale, 1);
    for (size_t k = 0; k < in->count; k++) {
        work_allow(NUMBER_WORK);
        work_on(s->scale, mpq_denref(in->x[k]));
        mpz_lcm(s->scale, s->scale, mpq_denref(in->x[k]));
        size_t bits = mpz_sizeinbase(s->scale, 2);
        if (bits > MOST_BITS || in->count > MOST_SCALED / bits)
            give_up("%zu coordinates with a common denominator of %zu bits", in->count, bits);
    }
    s->x = integers(in->count / d * (d + 1));
    for (size_t k = 0; k < in->count; k++) {
        mpz_t *x = solid_vertex(s, k / d);
        work_allow(NUMBER_WORK);
        work_on(s->scale, mpq_denref(in->x[k]));
        mpz_divexact(x[k % d], s->scale, mpq_denref(in->x[k]));
        work_on(x[k % d], mpq_numref(in->x[k]));
        mpz_mul(x[k % d], x[k % d], mpq_numref(in->x[k]));
        mpz_set_ui(x[d], 1);
        mpq_clear(in->x[k]);
    }
    free(in->x);
}

/* Read the next token, which must be the first of a line if `first` is 1, and must not be if it is
 * 0. */
static word off_token(draft *in, int first, const char *what) {
    word w = token(&in->f);
    if (w.length == 0 || in->f.first != first)
        source_fail(&in->f, what);
    return w;
}

static void read_facet(solid *s, draft *in, size_t facet) {
    static const char what[] =
        "a facet is not its number of corners and as many numbers of vertices";
    size_t n, v[3] = {0, 0, 0}; /* the first corner, the one before, this one */
    if (!count_read(&n, off_token(in, 1, what)) || n < 3)
        source_fail(&in->f, what);
    for (size_t k = 0; k < n; k++) {
        if (!count_read(&v[2], off_token(in, 0, what)) || v[2] >= in->count / 3)
            source_fail(&in->f, what);
        if (k > 1) {
            add_simplex(s, v[0], v[1], v[2], facet);
            s->simplex[s->count - 1].diagonals = (k > 2 ? 1u : 0) | (k + 1 < n ? 4u : 0);
        }
        v[k > 0] = v[2];
    }
}

static void read_off(solid *s, draft *in) {
    size_t counts[3] = {0, 0, 0};
    token_want(&in->f, "OFF");
    for (int k = 0; k < 3; k++)
        if (!count_read(&counts[k], token(&in->f)))
            source_fail(&in->f, "three counts are expected");
    for (size_t v = 0; v < counts[0]; v++)
        for (int k = 0; k < 3; k++)
            add_number(in, off_token(in, k == 0, "a vertex is not three numbers on a line"));
    for (size_t k = 0; k < counts[1]; k++)
        read_facet(s, in, k);
    if (token(&in->f).length > 0)
        source_fail(&in->f, "text follows the last facet");
}

/* sum += a b if `add` is mpq_add, sum -= a b if it is mpq_sub. */
static void add_product(mpq_t sum, mpq_srcptr a, mpq_srcptr b,
                        void (*add)(mpq_ptr, mpq_srcptr, mpq_srcptr)) {
    mpq_t term;
    mpq_init(term);
    work_on_fractions(a, b);
    mpq_mul(term, a, b);
    work_on_fractions(sum, term);
    add(sum, sum, term);
    mpq_clear(term);
}

/* The sign of the area of the ring of positions [first, end); the last position repeats the first.
 */
static int ring_sign(const draft *in, size_t first, size_t end) {
    mpq_t sum;
    mpq_init(sum);
    for (size_t k = first; k + 1 < end; k++) {
        work_allow(NUMBER_WORK);
        add_product(sum, in->x[2 * k], in->x[2 * k + 3], mpq_add);
        add_product(sum, in->x[2 * k + 1], in->x[2 * k + 2], mpq_sub);
    }
    int sign = mpq_sgn(sum);
    mpq_clear(sum);
    return sign;
}

static void drop_position(draft *in) {
    for (int i = 0; i < 2; i++)
        mpq_clear(in->x[--in->count]);
}

static int same_position(const draft *in, size_t v, size_t w) {
    return mpq_equal(in->x[2 * v], in->x[2 * w]) && mpq_equal(in->x[2 * v + 1], in->x[2 * w + 1]);
}

static void read_ring(solid *s, draft *in, int outer, size_t polygon) {
    size_t first = in->count / 2;
    token_want(&in->f, "(");
    do {
        add_number(in, token(&in->f));
        add_number(in, token(&in->f));
    } while (token_goes_on(&in->f, ")"));
    size_t last = in->count / 2 - 1;
    if (!same_position(in, first, last))
        source_fail(&in->f, "the last position of a ring is not its first");
    int sign = ring_sign(in, first, last + 1), ahead = (sign > 0) == outer;
    if (sign == 0)
        refute("solid: a ring of polygon %zu has no area", polygon);
    for (size_t k = first; k < last; k++) {
        size_t next = k + 1 < last ? k + 1 : first;
        int skip = same_position(in, k, next); /* a side of length 0 is left out */
        s->twin = room_for(s->twin, k, &s->twin_room, sizeof *s->twin);
        s->twin[k] = skip ? next : k;
        if (!skip)
            add_simplex(s, ahead ? k : next, ahead ? next : k, 0, polygon);
    }
    drop_position(in); /* the closing one */
}

static void read_polygon(solid *s, draft *in, size_t polygon) {
    int outer = 1;
    token_want(&in->f, "(");
    do {
        read_ring(s, in, outer, polygon);
        outer = 0;
    } while (token_goes_on(&in->f, ")"));
}

static void read_wkt(solid *s, draft *in) {
    size_t polygon = 0;
    word w = token(&in->f);
    if (word_is(w, "POLYGON")) {
        read_polygon(s, in, 0);
    } else if (word_is(w, "MULTIPOLYGON")) {
        token_want(&in->f, "(");
        do
            read_polygon(s, in, polygon++);
        while (token_goes_on(&in->f, ")"));
    } else
        source_fail(&in->f, "POLYGON or MULTIPOLYGON is expected");
    if (token(&in->f).length > 0)
        source_fail(&in->f, "text follows the last ')'");
}

/* Test one more piece of the fan of a facet: it must lie in the plane of the piece before it, and
 * be turned the same way. */
static void check_fan(const solid *s, const simplex *before, const simplex *f) {
    mpz_t value;
    mpz_init(value);
    if (form_value(value, before->plane, solid_vertex(s, f->v[2]), 4) != 0)
        refute("solid: facet %zu is not planar", f->facet);
    if (mpz_sgn(before->plane[before->axis]) != mpz_sgn(f->plane[before->axis]))
        give_up("solid: facet %zu is not the fan of its first corner; expected what graze convert "
                "writes",
                f->facet);
    mpz_clear(value);
}

solid solid_read(const char *path, const char *sha256) {
    solid s = {.d = 0};
    draft in = {.f = source_open(path, sha256, "()," BLANKS)};
    const char *dot = strrchr(path, '.');
    if (dot && strcmp(dot, ".off") == 0) {
        s.d = 3;
        in.f.marks = BLANKS;
        in.f.comments = 1;
        read_off(&s, &in);
    } else if (dot && strcmp(dot, ".wkt") == 0) {
        s.d = 2;
        read_wkt(&s, &in);
    } else
        give_up("%s: a solid in .off or .wkt is expected", path);
    take_positions(&s, &in);
    solid_make_forms(&s);
    for (size_t k = 1; k < s.count; k++)
        if (s.d == 3 && s.simplex[k].facet == s.simplex[k - 1].facet)
            check_fan(&s, &s.simplex[k - 1], &s.simplex[k]);
    solid_make_tree(&s);
    return s;
}
