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

/* Binary places of parameters beyond those of coordinates. */
enum { WHERE_PLACES = 128 };

void outline_polygon_clear(outline_polygon *p) {
    for (size_t k = 0; k < p->count; k++)
        dyadic_interval_clear(&p->edge[k].where);
    free(p->edge);
    free(p->first);
    free(p->within);
}

static graze_status too_near(graze_context *context) {
    return context_fail(context, GRAZE_ELIMIT,
                        "a polygon near the outline: its edges, with coordinates that are doubles, "
                        "meet where arcs do not");
}

graze_status polygon_edge_start(const outline_polygon *p, size_t edge, const fmpq *point) {
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

graze_status polygon_edge_add(outline_polygon *p, size_t arc, size_t node) {
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
    TRY(polygon_edge_add(p, arc, from));
    TRY(outline_curve_corners(corner, p->context, c, c->cut[start->cut], POINT_PLACES));
    TRY(polygon_edge_start(p, k, corner));
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
    TRY(polygon_edge_add(p, p->edge[k].arc, ~p->count)); /* no point's number */
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
    return polygon_edge_start(p, p->count - 1, point);
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

int polygon_turn(const slong *p, const slong *q, const slong *r) {
    __extension__ typedef __int128 wide;
    wide left = (wide)(q[0] - p[0]) * (r[1] - p[1]), right = (wide)(q[1] - p[1]) * (r[0] - p[0]);
    return (left > right) - (left < right);
}

int polygon_edges_meet(const outline_polygon *p, const polygon_edge *e, const polygon_edge *f) {
    const polygon_edge *x[2] = {e, &p->edge[e->next]}, *y[2] = {f, &p->edge[f->next]};
    const slong *a = x[0]->at, *b = x[1]->at, *c = y[0]->at, *d = y[1]->at;
    int shared = 0, overlap = 0, ahead = 0;
    for (int s = 0; s < 4; s++) {
        const slong *hub = x[s & 1]->at, *to = x[~s & 1]->at, *other = y[~s >> 1 & 1]->at;
        if (x[s & 1]->node != y[s >> 1]->node)
            continue;
        shared++;
        for (int i = 0; i < 2; i++)
            ahead |= (to[i] > hub[i] && other[i] > hub[i]) || (to[i] < hub[i] && other[i] < hub[i]);
        overlap = ahead && polygon_turn(hub, to, other) == 0;
    }
    return shared ? shared > 1 || overlap
                  : polygon_turn(a, b, c) * polygon_turn(a, b, d) <= 0 &&
                        polygon_turn(c, d, a) * polygon_turn(c, d, b) <= 0;
}

/* The box of an edge. */
typedef struct edge_box {
    slong low[2], high[2];
    size_t edge;
    int second;
} edge_box;

static int compare_edge_boxes(const void *left, const void *right) {
    const edge_box *a = left, *b = right;
    return a->low[0] != b->low[0] ? (a->low[0] < b->low[0] ? -1 : 1)
                                  : (a->edge > b->edge) - (a->edge < b->edge);
}

static void put_edge_boxes(edge_box *out, const outline_polygon *p, slong more, int second) {
    for (size_t k = 0; k < p->count; k++) {
        const slong *a = p->edge[k].at, *b = p->edge[p->edge[k].next].at;
        out[k] = (edge_box){.edge = k, .second = second};
        for (int i = 0; i < 2; i++) {
            out[k].low[i] = FLINT_MIN(a[i], b[i]) - more;
            out[k].high[i] = FLINT_MAX(a[i], b[i]) + more;
        }
    }
}

graze_status polygon_pairs(const outline_polygon *p, const outline_polygon *q, slong more,
                           polygon_visit *visit, void *state) {
    size_t count = p->count + (q ? q->count : 0);
    FREED(edge_box, sorted, malloc((count + 1) * sizeof *sorted));
    if (!sorted)
        return context_fail(p->context, GRAZE_ESYSTEM, "out of memory for a polygon");
    put_edge_boxes(sorted, p, 0, 0);
    if (q)
        put_edge_boxes(sorted + p->count, q, more, 1);
    qsort(sorted, count, sizeof *sorted, compare_edge_boxes);
    for (size_t i = 0; i < count; i++) {
        const edge_box *a = sorted + i;
        for (const edge_box *b = a + 1; b < sorted + count && b->low[0] <= a->high[0]; b++)
            if (a->low[1] <= b->high[1] && b->low[1] <= a->high[1] &&
                (!q || a->second != b->second))
                TRY(visit(state, a->second ? b->edge : a->edge, a->second ? a->edge : b->edge));
        TRY(context_work(p->context, 1000));
    }
    return GRAZE_OK;
}

/* Mark the edges to halve of two that meet. */
static graze_status mark_meeting(void *state, size_t first, size_t second) {
    outline_polygon *p = state;
    polygon_edge *e = &p->edge[first], *f = &p->edge[second];
    if (!polygon_edges_meet(p, e, f))
        return GRAZE_OK;
    f->split |= f->curved;
    e->split |= e->curved || !f->curved;
    return GRAZE_OK;
}

graze_status polygon_meetings(int *clear, outline_polygon *p) {
    TRY(polygon_pairs(p, NULL, 0, mark_meeting, p));
    for (size_t k = 0; k < p->count; k++) {
        polygon_edge *e = &p->edge[k];
        const slong *end = p->edge[e->next].at;
        e->split |= e->at[0] == end[0] && e->at[1] == end[1];
        *clear = *clear && !e->split;
    }
    return GRAZE_OK;
}

int polygon_winding(const outline_polygon *p, size_t first, const slong *x, size_t but) {
    size_t k = first;
    int around = 0;
    do {
        size_t edge = k;
        const slong *a = p->edge[k].at, *b = p->edge[k = p->edge[k].next].at;
        const slong twice[2][2] = {{2 * a[0], 2 * a[1]}, {2 * b[0], 2 * b[1]}};
        int up = b[1] > a[1] ? 1 : -1;
        if (edge != but && (twice[0][1] > x[1]) != (twice[1][1] > x[1]))
            around += polygon_turn(twice[0], twice[1], x) == up ? up : 0;
    } while (k != first);
    return around;
}

int polygon_ring_has(const outline_polygon *p, size_t s, size_t edge) {
    const polygon_edge *from = &p->edge[edge], *to = &p->edge[from->next];
    const slong x[2] = {from->at[0] + to->at[0], from->at[1] + to->at[1]};
    return polygon_winding(p, p->first[s], x, p->count) & 1;
}

graze_status polygon_nest(outline_polygon *p) {
    FREED(size_t, depth, calloc(p->ring_count + 1, sizeof *depth));
    if (!depth)
        return context_fail(p->context, GRAZE_ESYSTEM, "out of memory for a polygon");
    for (int pass = 0; pass < 2; pass++)
        for (size_t r = 0; r < p->ring_count; r++) {
            p->within[r] = r;
            for (size_t s = 0; s < p->ring_count; s++) {
                if (s == r || (pass && (depth[r] % 2 == 0 || depth[s] + 1 != depth[r])) ||
                    !polygon_ring_has(p, s, p->first[r]))
                    continue;
                p->within[r] = pass ? s : r;
                depth[r] += !pass;
            }
            TRY(context_work(p->context, 1000 * p->ring_count));
        }
    return GRAZE_OK;
}

/* Are holes in their own rings, with no ring between, and other rings in holes alone, and does no
 * ring cross another at a corner? Where a ring passes corners of others, each of its parts between
 * these must be within the same rings. */
static graze_status check_nesting(int *out, outline_polygon *p) {
    const graze_outline *o = p->o;
    FREED(size_t, rings_at, calloc(o->point_count + 1, sizeof *rings_at));
    FREED(char, around, calloc(o->ring_count + 1, 1));
    if (!rings_at || !around)
        return context_fail(p->context, GRAZE_ESYSTEM, "out of memory for a polygon");
    for (size_t k = 0; k < o->arc_count; k++)
        rings_at[o->arc[k].from]++;
    for (size_t r = 0; r < o->ring_count; r++)
        for (size_t i = 0; i < o->ring[r].count; i++) {
            size_t arc = o->ring_arc[o->ring[r].first + i];
            for (size_t s = 0; s < o->ring_count && (i == 0 || rings_at[o->arc[arc].from] > 1);
                 s++) {
                char within = s != r && polygon_ring_has(p, s, arc);
                *out = *out && (i == 0 || within == around[s]);
                around[s] = within;
                TRY(context_work(p->context, 1000));
            }
        }
    TRY(polygon_nest(p));
    for (size_t r = 0; r < o->ring_count; r++)
        *out = *out && p->within[r] == (o->ring[r].hole ? o->ring[r].within : r);
    return GRAZE_OK;
}

graze_status polygon_rings(outline_polygon *p, size_t count) {
    p->ring_count = count;
    p->first = calloc(count + 1, sizeof *p->first);
    p->within = calloc(count + 1, sizeof *p->within);
    return p->first && p->within
               ? GRAZE_OK
               : context_fail(p->context, GRAZE_ESYSTEM, "out of memory for a polygon");
}

/* Begin with an edge for each arc, joined to rings. */
static graze_status begin_rings(outline_polygon *p) {
    const graze_outline *o = p->o;
    TRY(polygon_rings(p, o->ring_count));
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

/* Halve edges that are marked, or not near their parts. */
static graze_status refine_edges(outline_polygon *p) {
    for (size_t k = 0; k < p->count; k++)
        while (p->edge[k].split ||
               (p->edge[k].curved && !p->edge[k].fine && !is_fine(p, &p->edge[k])))
            TRY(halve_edge(p, k));
    for (size_t k = 0; k < p->count; k++)
        p->edge[k].fine = 1;
    return GRAZE_OK;
}

graze_status polygon_parts(outline_polygon *p, const graze_outline *o, graze_context *context,
                           double within) {
    int exponent = outline_exponent(o);
    *p =
        (outline_polygon){.o = o, .context = context, .places = (ulong)FLINT_MAX(52 - exponent, 0)};
    p->distance = fmin(ldexp(within, (int)p->places), 1e18);
    if (p->distance < 1 || exponent > 52)
        return too_near(context);
    TRY(begin_rings(p));
    return refine_edges(p);
}

graze_status outline_polygon_make(outline_polygon *p, const graze_outline *o,
                                  graze_context *context, double within) {
    int done = 0;
    TRY(polygon_parts(p, o, context, within));
    for (size_t before = 0; !done; before = p->count) {
        TRY(refine_edges(p));
        if (p->count && p->count == before)
            return too_near(context);
        done = 1;
        TRY(polygon_meetings(&done, p));
        if (!done)
            continue;
        TRY(check_nesting(&done, p));
        for (size_t k = 0; k < p->count && !done; k++)
            p->edge[k].split = p->edge[k].curved;
    }
    return GRAZE_OK;
}
