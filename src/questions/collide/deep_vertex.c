/* A vertex that is inside the other solid at a time stays inside from its trajectory's last contact
 * with that boundary before the time to its first contact after it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "questions/collide/placing.h"

/* Bounds of the number of vertices tried for each solid, and of the number of trajectories traced.
 */
enum { MOST_TRIED = 16, MOST_TRACED = 4 };

/* Set [low, high] to the times between a vertex's last contact with the other boundary before a
 * time, or -1, and its first contact after it, or 2, past the piece's ends. */
static graze_status time_free(fmpq_t low, fmpq_t high, placing *p, pair_side side, uint32_t vertex,
                              algebraic *time) {
    const graze_solid *other = placing_solid(p, (pair_side)!side);
    const trajectory *c = placing_vertex(p, side, vertex);
    ZEROED(candidates, list);
    LOCAL_VEC(fmpq, from, 2);
    fmpq *to = from + 1;
    HELD(touches, found);
    fmpq_set_si(low, -1, 1);
    fmpq_set_si(high, 2, 1);
    TRY(p->status);
    TRY(candidates_find(&list, p->context, other, c));
    TRY(touches_find(&found, p->context, other, c, NULL, &list));
    for (size_t k = 0; k < found.time.count; k++) {
        int order = 0;
        TRY(algebraic_compare(&order, p->context, &found.time.item[k], time));
        algebraic_bounds(from, to, &found.time.item[k]);
        if (order < 0 && fmpq_cmp(to, low) > 0)
            fmpq_set(low, to);
        if (order > 0 && fmpq_cmp(from, high) < 0)
            fmpq_set(high, from);
    }
    return GRAZE_OK;
}

/* Find the interval of a vertex that is in the other solid's interior at `time`; keep it if it is
 * longer than `out`. */
static graze_status trace_vertex(deep_interval *out, placing *whole, pair_side side,
                                 uint32_t vertex, algebraic *time) {
    LOCAL_VEC(fmpq, low, 3);
    fmpq *high = low + 1, *width = low + 2;
    TRY(time_free(low, high, whole, side, vertex, time));
    fmpq_sub(width, out->high, out->low);
    fmpq_add(width, width, low);
    if (fmpq_cmp(high, width) > 0) {
        fmpq_set(out->low, low);
        fmpq_set(out->high, high);
    }
    return GRAZE_OK;
}

/* Set u to a rational time before the placing's time and after the last contact of a vertex's
 * trajectory with the other boundary before that. */
static graze_status time_before_root(fmpq_t u, placing *p, pair_side side, uint32_t vertex) {
    LOCAL(fmpq, high);
    HELD(algebraic, low);
    TRY(time_free(low.value, high, p, side, vertex, p->when));
    if (fmpq_sgn(low.value) < 0)
        fmpq_zero(low.value);
    return algebraic_between(u, p->context, &low, p->when);
}

int placing_in_interior_then(placing *p, pair_side side, uint32_t vertex) {
    if (p->is_frozen || p->pair->round[!side])
        return placing_in_interior(p, side, vertex);
    LOCAL(fmpq, u);
    p->status = p->status ? p->status : time_before_root(u, p, side, vertex);
    HELD(placing, before, p->context, p->pair, p->piece, u);
    int inside = !p->status && placing_in_interior(&before, side, vertex);
    p->status = p->status ? p->status : before.status;
    return inside;
}

graze_status deep_vertex_find(deep_interval *out, placing *whole, size_t piece,
                              const near_list *near, const dyadic_interval *interval) {
    int traced = 0;
    HELD(algebraic, middle);
    fmpz_add(fmpq_numref(middle.value), interval->low, interval->high);
    fmpq_div_2exp(middle.value, middle.value, interval->exponent + 1);
    fmpq_zero(out->low);
    fmpq_zero(out->high);
    HELD(placing, at, whole->context, whole->pair, piece, middle.value);
    for (size_t k = 0; k < 2 * MOST_TRIED && traced < MOST_TRACED; k++) {
        near_pair s = near->item[(k / 2) * near->count / MOST_TRIED];
        pair_side side = k % 2 ? SIDE_FIXED : SIDE_MOVING;
        uint32_t vertex = placing_solid(whole, side)->cut.item[simplex_of(s, side)].vertex[0];
        int inside = placing_in_interior(&at, side, vertex);
        TRY(at.status);
        if (inside) {
            TRY(trace_vertex(out, whole, side, vertex, &middle));
            traced++;
        }
    }
    return GRAZE_OK;
}
