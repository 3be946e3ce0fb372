/* Nearest points, exactly: the foot on a segment is rational.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpq_vec.h>
#include "base/context/scope.h"
#include "questions/contact/nearby.h"

void nearby_init(nearby *n, const fmpq *from, int dimension) {
    n->dimension = dimension;
    n->found = 0;
    n->from = from;
    n->point = _fmpq_vec_init(dimension);
    fmpq_init(n->square);
}

void nearby_clear(nearby *n) {
    _fmpq_vec_clear(n->point, n->dimension);
    fmpq_clear(n->square);
}

static int lexicographic_order(const fmpq *a, const fmpq *b, int d) {
    int order = 0;
    for (int i = 0; i < d && !order; i++)
        order = fmpq_cmp(a + i, b + i);
    return order;
}

void nearby_try(nearby *n, const fmpq *point) {
    int d = n->dimension;
    LOCAL_VEC(fmpq, way, d);
    LOCAL(fmpq, square);
    for (int i = 0; i < d; i++)
        fmpq_sub(way + i, point + i, n->from + i);
    _fmpq_vec_dot(square, way, way, d);
    int order = n->found ? fmpq_cmp(square, n->square) : -1;
    if (order < 0 || (order == 0 && lexicographic_order(point, n->point, d) < 0)) {
        fmpq_swap(n->square, square);
        for (int i = 0; i < d; i++)
            fmpq_set(n->point + i, point + i);
        n->found = 1;
    }
}

/* The foot is at a + s (b - a), s = (from - a)(b - a) / |b - a|^2, held to [0, 1]. */
void nearby_try_segment(nearby *n, const fmpq *a, const fmpq *b) {
    int d = n->dimension;
    LOCAL_VEC(fmpq, along, 3 * d);
    fmpq *way = along + d, *foot = way + d;
    LOCAL_VEC(fmpq, s, 2);
    fmpq *length = s + 1;
    for (int i = 0; i < d; i++) {
        fmpq_sub(along + i, b + i, a + i);
        fmpq_sub(way + i, n->from + i, a + i);
    }
    _fmpq_vec_dot(length, along, along, d);
    _fmpq_vec_dot(s, way, along, d);
    if (fmpq_sgn(s) <= 0) {
        nearby_try(n, a);
    } else if (fmpq_cmp(s, length) >= 0) {
        nearby_try(n, b);
    } else {
        fmpq_div(s, s, length);
        for (int i = 0; i < d; i++) {
            fmpq_set(foot + i, a + i);
            fmpq_addmul(foot + i, s, along + i);
        }
        nearby_try(n, foot);
    }
}
