/* Simple polygons of doubles near an outline (proofs/outline.md C145).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Coordinates are integers of at most 53 bits, in units of a power of 2, so that tests of edges are
 * exact in 128 bits.
 */
#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "questions/outline/arc_complex.h"

__extension__ typedef __int128 wide;

/* Binary places of parameters beyond those of coordinates. */
enum { WHERE_PLACES = 128 };

void outline_polygon_clear(outline_polygon *p) {
    for (size_t k = 0; k < p->count; k++)
        dyadic_interval_clear(&p->edge[k].where);
    free(p->edge);
    free(p->first);
}

static graze_status too_near(graze_context *context) {
    return context_fail(context, GRAZE_ELIMIT,
                        "a polygon near the outline: its edges, with coordinates that are doubles, "
                        "meet where arcs do not");
}

/* Let an edge begin at a point, rounded. */
static graze_status set_start(const outline_polygon *p, size_t edge, const fmpq *point) {
    LOCAL(fmpq, x);
    LOCAL(fmpz, nearest);
    for (int k = 0; k < 2; k++) {
        fmpq_mul_2exp(x, point + k, p->places + 1);
        fmpz_add(nearest, fmpq_numref(x), fmpq_denref(x));
        fmpz_mul_2exp(fmpq_denref(x), fmpq_denref(x), 1);
        fmpz_fdiv_q(nearest, nearest, fmpq_denref(x));
        if (fmpz_bits(nearest) > 53)
            return too_near(p->context);
        p->edge[edge].at[k] = fmpz_get_si(nearest);
    }
    return GRAZE_OK;
}

/* Append an edge for a part of an arc. */
static graze_status add_polygon_edge(outline_polygon *p, size_t arc, size_t node) {
    if (p->count >= p->context->limits[GRAZE_LIMIT_ARCS])
        return context_limit(p->context, GRAZE_LIMIT_ARCS, "the edges of a polygon");
    TRY(array_grow(p->context, &p->edge, &p->capacity, p->count + 1, sizeof *p->edge,
                   "the edges of a polygon"));
    p->edge[p->count++] = (polygon_edge){.arc = arc, .node = node};
    return context_work(p->context, 10000);
}

static const outline_piece *piece_of(const outline_polygon *p, const polygon_edge *e) {
    return &p->o->piece[p->o->arc_piece[p->o->arc[e->arc].first]];
}

/* Make one edge for an arc. */
static graze_status begin_arc(outline_polygon *p, size_t arc) {
    LOCAL_VEC(fmpq, corner, 4);
    HELD(bracket, low);
    HELD(bracket, high);
    algebraic *end[2];
    size_t k = p->count, from = p->o->arc[arc].from;
    const outline_point *start = &p->o->point[from];
    outline_curve *c = &p->o->curve[start->curve];
    TRY(add_polygon_edge(p, arc, from));
    TRY(outline_curve_corners(corner, p->context, c, c->cut[start->cut], p->places + 8));
    TRY(set_start(p, k, corner));
    polygon_edge *e = &p->edge[k];
    e->curved = !outline_is_straight(p->o, &p->o->curve[piece_of(p, e)->curve]);
    outline_arc_ends(end, p->o, &p->o->arc[arc]);
    e->where.exponent = p->places + WHERE_PLACES;
    TRY(bracket_of_number(&low, p->context, end[0], e->where.exponent));
    TRY(bracket_of_number(&high, p->context, end[1], e->where.exponent));
    fmpz_swap(e->where.low, low.low);
    fmpz_swap(e->where.high, high.high);
    return GRAZE_OK;
}

/* Halve an edge at the middle of its parameters. That is within the arc: the interval is longer
 * than the brackets of the arc's ends. */
static graze_status halve_edge(outline_polygon *p, size_t k) {
    LOCAL_VEC(fmpq, point, 2);
    LOCAL(fmpq, s);
    const outline_piece *piece = piece_of(p, &p->edge[k]);
    TRY(add_polygon_edge(p, p->edge[k].arc, p->o->point_count + p->count));
    polygon_edge *e = &p->edge[k], *half = &p->edge[p->count - 1];
    fmpz_sub(fmpq_numref(s), e->where.high, e->where.low);
    if (!e->curved || fmpz_bits(fmpq_numref(s)) + p->places + WHERE_PLACES < e->where.exponent + 8)
        return too_near(p->context);
    dyadic_interval_halves(&e->where, &half->where, &e->where);
    dyadic_value(s, half->where.low, half->where.exponent);
    outline_curve_at(point, &p->o->curve[piece->curve], s);
    if (piece->turn < 0)
        dyadic_interval_swap(&e->where, &half->where);
    half->curved = 1;
    half->next = e->next;
    e->next = p->count - 1;
    e->split = e->fine = 0;
    return set_start(p, p->count - 1, point);
}

/* Is each control point of the part within the distance of the edge's point with its number? All of
 * the part is within the distance of the edge then. */
static int is_fine(const outline_polygon *p, const polygon_edge *e) {
    const outline_piece *piece = piece_of(p, e);
    const outline_curve *c = &p->o->curve[piece->curve];
    const slong *end[2] = {e->at, p->edge[e->next].at}, backward = piece->turn < 0;
    slong n = outline_curve_degree(c), size = n + 1;
    LOCAL_VEC(fmpz, b, 3 * size);
    LOCAL_VEC(fmpq, x, 4);
    for (slong k = 0; k < 3; k++)
        bernstein_from_poly(b + k * size, &c->x[k], n, &e->where);
    fmpq_set_si(x + 3, (slong)p->distance, 1);
    fmpq_mul(x + 3, x + 3, x + 3);
    for (slong i = 0; i <= n; i++) {
        const fmpz *weight = b + 2 * size + i;
        if (fmpz_sgn(weight) * fmpz_sgn(b + 2 * size) <= 0)
            return 0;
        fmpq_zero(x + 2);
        for (slong k = 0; k < 2; k++) {
            fmpq_set_fmpz_frac(x, b + k * size + i, weight);
            fmpq_mul_2exp(x, x, p->places);
            fmpq_set_si(x + 1, end[!backward][k] - end[backward][k], (ulong)n);
            fmpq_mul_si(x + 1, x + 1, i);
            fmpq_add_si(x + 1, x + 1, end[backward][k]);
            fmpq_sub(x, x, x + 1);
            fmpq_addmul(x + 2, x, x);
        }
        if (fmpq_cmp(x + 2, x + 3) > 0)
            return 0;
    }
    return 1;
}

static int turn_of(const slong *p, const slong *q, const slong *r) {
    wide left = (wide)(q[0] - p[0]) * (r[1] - p[1]), right = (wide)(q[1] - p[1]) * (r[0] - p[0]);
    return (left > right) - (left < right);
}

/* Have two edges more in common than one node? */
static int polygon_edges_meet(const outline_polygon *p, const polygon_edge *e,
                              const polygon_edge *f) {
    const polygon_edge *x[2] = {e, &p->edge[e->next]}, *y[2] = {f, &p->edge[f->next]};
    const slong *a = x[0]->at, *b = x[1]->at, *c = y[0]->at, *d = y[1]->at;
    int shared = 0, overlap = 0, ahead = 0;
    for (int i = 0; i < 2; i++)
        if (FLINT_MIN(a[i], b[i]) > FLINT_MAX(c[i], d[i]) ||
            FLINT_MAX(a[i], b[i]) < FLINT_MIN(c[i], d[i]))
            return 0;
    for (int s = 0; s < 4; s++) {
        const slong *hub = x[s & 1]->at, *to = x[~s & 1]->at, *other = y[~s >> 1 & 1]->at;
        if (x[s & 1]->node != y[s >> 1]->node)
            continue;
        shared++;
        for (int i = 0; i < 2; i++)
            ahead |= (to[i] > hub[i] && other[i] > hub[i]) || (to[i] < hub[i] && other[i] < hub[i]);
        overlap = ahead && turn_of(hub, to, other) == 0;
    }
    return shared ? shared > 1 || overlap
                  : turn_of(a, b, c) * turn_of(a, b, d) <= 0 &&
                        turn_of(c, d, a) * turn_of(c, d, b) <= 0;
}

/* An edge, by its least x. */
typedef struct sorted_edge {
    slong low;
    size_t edge;
} sorted_edge;

static int compare_polygon_edges(const void *left, const void *right) {
    const sorted_edge *a = left, *b = right;
    return a->low != b->low ? (a->low < b->low ? -1 : 1)
                            : (a->edge > b->edge) - (a->edge < b->edge);
}

/* Mark the edges to halve: those that meet others. */
static graze_status find_meetings(int *clear, outline_polygon *p) {
    FREED(sorted_edge, sorted, malloc((p->count + 1) * sizeof *sorted));
    if (!sorted)
        return context_fail(p->context, GRAZE_ESYSTEM, "out of memory for a polygon");
    for (size_t k = 0; k < p->count; k++)
        sorted[k] = (sorted_edge){FLINT_MIN(p->edge[k].at[0], p->edge[p->edge[k].next].at[0]), k};
    qsort(sorted, p->count, sizeof *sorted, compare_polygon_edges);
    for (size_t i = 0; i < p->count; i++) {
        polygon_edge *e = &p->edge[sorted[i].edge];
        const polygon_edge *end = &p->edge[e->next];
        e->split |= e->at[0] == end->at[0] && e->at[1] == end->at[1];
        for (size_t j = i + 1; j < p->count; j++) {
            polygon_edge *f = &p->edge[sorted[j].edge];
            if (sorted[j].low > FLINT_MAX(e->at[0], end->at[0]))
                break;
            if (!polygon_edges_meet(p, e, f))
                continue;
            f->split |= f->curved;
            e->split |= e->curved || !f->curved;
        }
        *clear = *clear && !e->split;
        TRY(context_work(p->context, 1000));
    }
    return GRAZE_OK;
}

/* Is the middle of an edge within ring s, which does not pass it? */
static int ring_has(const outline_polygon *p, size_t s, size_t edge) {
    size_t first = p->first[s], k = first;
    const polygon_edge *from = &p->edge[edge], *to = &p->edge[from->next];
    const slong x[2] = {from->at[0] + to->at[0], from->at[1] + to->at[1]};
    int inside = 0;
    do {
        const slong *a = p->edge[k].at, *b = p->edge[k = p->edge[k].next].at;
        const slong twice[2][2] = {{2 * a[0], 2 * a[1]}, {2 * b[0], 2 * b[1]}};
        if ((twice[0][1] > x[1]) != (twice[1][1] > x[1]))
            inside ^= turn_of(twice[0], twice[1], x) == (b[1] > a[1] ? 1 : -1);
    } while (k != first);
    return inside;
}

/* Count the rings around ring r, and mark them. Where it passes corners of other rings, each of its
 * parts between these must be within the same rings: else it crosses one there. */
static graze_status find_rings_around(int *out, size_t *depth, char *around,
                                      const outline_polygon *p, size_t r, const size_t *rings_at) {
    const size_t *arc = p->o->ring_arc + p->o->ring[r].first;
    for (size_t i = 0; i < p->o->ring[r].count; i++)
        for (size_t s = 0; s < p->o->ring_count && (i == 0 || rings_at[p->o->arc[arc[i]].from] > 1);
             s++) {
            char within = s != r && ring_has(p, s, arc[i]);
            *depth += i == 0 && within;
            *out = *out && (i == 0 || within == around[s]);
            around[s] = within;
            TRY(context_work(p->context, 1000));
        }
    return GRAZE_OK;
}

/* Are holes in their own rings, with no ring between, and other rings in holes alone, and does no
 * ring cross another at a corner? */
static graze_status check_nesting(int *out, const outline_polygon *p) {
    const graze_outline *o = p->o;
    FREED(size_t, depth, calloc(o->ring_count + 1, sizeof *depth));
    FREED(size_t, rings_at, calloc(o->point_count + 1, sizeof *rings_at));
    FREED(char, around, calloc(o->ring_count + 1, 2));
    if (!depth || !rings_at || !around)
        return context_fail(p->context, GRAZE_ESYSTEM, "out of memory for a polygon");
    char *in_own = around + o->ring_count;
    for (size_t k = 0; k < o->arc_count; k++)
        rings_at[o->arc[k].from]++;
    for (size_t r = 0; r < o->ring_count; r++) {
        TRY(find_rings_around(out, &depth[r], around, p, r, rings_at));
        in_own[r] = around[o->ring[r].within];
    }
    for (size_t r = 0; r < o->ring_count; r++)
        *out = *out && (o->ring[r].hole ? depth[r] == depth[o->ring[r].within] + 1 && in_own[r]
                                        : depth[r] % 2 == 0);
    return GRAZE_OK;
}

/* Begin with an edge for each arc, joined to rings. */
static graze_status begin_rings(outline_polygon *p) {
    const graze_outline *o = p->o;
    p->first = calloc(o->ring_count + 1, sizeof *p->first);
    if (!p->first)
        return context_fail(p->context, GRAZE_ESYSTEM, "out of memory for a polygon");
    for (size_t k = 0; k < o->arc_count; k++)
        TRY(begin_arc(p, k));
    for (size_t r = 0; r < o->ring_count; r++) {
        const size_t *arc = o->ring_arc + o->ring[r].first, n = o->ring[r].count;
        p->first[r] = arc[0];
        for (size_t i = 0; i < n; i++)
            p->edge[arc[i]].next = arc[(i + 1) % n];
    }
    return GRAZE_OK;
}

graze_status outline_polygon_make(outline_polygon *p, const graze_outline *o,
                                  graze_context *context, double within) {
    int exponent = outline_exponent(o), done = 0;
    *p =
        (outline_polygon){.o = o, .context = context, .places = (ulong)FLINT_MAX(52 - exponent, 0)};
    p->distance = fmin(ldexp(within, (int)p->places), 1e18);
    if (p->distance < 1 || exponent > 52)
        return too_near(context);
    TRY(begin_rings(p));
    for (size_t before = 0; !done; before = p->count) {
        for (size_t k = 0; k < p->count; k++)
            while (p->edge[k].split ||
                   (p->edge[k].curved && !p->edge[k].fine && !is_fine(p, &p->edge[k])))
                TRY(halve_edge(p, k));
        for (size_t k = 0; k < p->count; k++)
            p->edge[k].fine = 1;
        if (p->count && p->count == before)
            return too_near(context);
        done = 1;
        TRY(find_meetings(&done, p));
        if (!done)
            continue;
        TRY(check_nesting(&done, p));
        for (size_t k = 0; k < p->count && !done; k++)
            p->edge[k].split = p->edge[k].curved;
    }
    return GRAZE_OK;
}
