/* Writes polyhedra of rings as OFF. Numbers are finite decimals where they have one, as other
 * programs read no ratios. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/convert/convert.h"

#include "base/context/scope.h"
#include "base/number/decimal.h"

static void put_vertex(text *t, const fmpq *v, const fmpq *at) {
    LOCAL(fmpq, sum);
    for (int k = 0; k < 3; k++) {
        fmpq_set(sum, v + k);
        if (at)
            fmpq_add(sum, sum, at + k);
        int finite = 0;
        char *decimal = decimal_finite(&finite, sum);
        if (finite)
            text_owned(t, decimal);
        else
            text_rational(t, sum);
        text_put(t, k < 2 ? " " : "\n");
    }
}

/* The number of corners of a ring: one where it has shrunk to a point. */
static size_t ring_corners(const profile *p, size_t ring, size_t sides) {
    return fmpq_is_zero(p->point + 2 * ring) ? 1 : sides;
}

static void put_rings(text *t, const profile *p, const tool_pair *pair, const fmpq_t factor,
                      const fmpq *at) {
    LOCAL_VEC(fmpq, v, 3);
    for (size_t i = 0; i < p->count; i++)
        for (size_t k = 0; k < ring_corners(p, i, pair->sides); k++) {
            for (int c = 0; c < 2; c++) {
                fmpq_mul(v + c, p->point + 2 * i, pair->corner + 2 * k + c);
                fmpq_mul(v + c, v + c, factor);
            }
            fmpq_set(v + 2, p->point + 2 * i + 1);
            put_vertex(t, v, at);
        }
}

/* Write a ring as a facet: the bottom, seen from below, or the top. */
static void put_ring_facet(text *t, size_t first, size_t sides, int top) {
    text_format(t, "%zu", sides);
    for (size_t k = 0; k < sides; k++)
        text_format(t, " %zu", first + (top ? k : sides - 1 - k));
    text_put(t, "\n");
}

/* Write the facets between two rings, whose first vertices are a and b. */
static void put_belt(text *t, size_t a, size_t a_size, size_t b, size_t b_size, size_t sides) {
    for (size_t k = 0; k < sides; k++) {
        size_t n = (k + 1) % sides;
        if (a_size == 1)
            text_format(t, "3 %zu %zu %zu\n", a, b + n, b + k);
        else if (b_size == 1)
            text_format(t, "3 %zu %zu %zu\n", a + k, a + n, b);
        else
            text_format(t, "4 %zu %zu %zu %zu\n", a + k, a + n, b + n, b + k);
    }
}

void tool_write(text *out, const profile *p, const tool_pair *pair, const fmpq_t factor,
                const fmpq *at) {
    size_t sides = pair->sides, last = p->count - 1, vertices = 0, first = 0;
    for (size_t i = 0; i < p->count; i++)
        vertices += ring_corners(p, i, sides);
    size_t bottom = ring_corners(p, 0, sides) > 1, top = ring_corners(p, last, sides) > 1;
    text_format(out, "OFF\n%zu %zu 0\n", vertices, last * sides + bottom + top);
    put_rings(out, p, pair, factor, at);
    if (bottom)
        put_ring_facet(out, 0, sides, 0);
    for (size_t i = 0; i < last; i++) {
        size_t own = ring_corners(p, i, sides);
        put_belt(out, first, own, first + own, ring_corners(p, i + 1, sides), sides);
        first += own;
    }
    if (top)
        put_ring_facet(out, first, sides, 1);
}

void tool_write_box(text *out, const fmpq *size, const fmpq *at) {
    static const int facet[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                    {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    LOCAL_VEC(fmpq, v, 3);
    text_put(out, "OFF\n8 6 0\n");
    for (int corner = 0; corner < 8; corner++) {
        for (int k = 0; k < 3; k++) {
            fmpq_zero(v + k);
            if (corner >> k & 1)
                fmpq_set(v + k, size + k);
        }
        put_vertex(out, v, at);
    }
    for (int k = 0; k < 6; k++)
        text_format(out, "4 %d %d %d %d\n", facet[k][0], facet[k][1], facet[k][2], facet[k][3]);
}
