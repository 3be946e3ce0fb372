/* Simple polygons of doubles on one side of an outline (proofs/outline.md C148).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Rings near the outline are shifted to the side, and those parts of them are kept that have the
 * winding number 0 on their right. Doubles say where to shift to; integers decide the rest.
 */
#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "questions/outline/arc_complex.h"

/* Units: the greatest error of edge_distance, and the least distance of arcs from their edges. */
enum { ATTEMPTS = 8, DISTANCE_ERROR = 128, LEAST_DISTANCE = 2048 };

/* The beginning of a shifted edge, or the place `at` on it at which another one crosses it. The
 * record of the beginning of edge k is number k; those of a crossing, on both edges, are
 * neighbours. `after`: the next one on the edge; 0: none. `change`: of the winding number there;
 * `right`: the number on the right side behind it. */
typedef struct shift_record {
    size_t edge, after;
    int change, right, used;
    fmpq at;
} shift_record;

/* `near`: rings near the outline; `shifted`: their edges shifted, `arc` being the one of `near`;
 * `out`: what is kept. `left`: 1 to shift to the left, -1 to the right. `wrong`: this attempt
 * fails.
 */
typedef struct shifting {
    const outline_polygon *near;
    outline_polygon shifted, *out;
    int left, wrong;
    double shift, loose;
    ulong chance;
    size_t count, capacity;
    shift_record *record;
} shifting;

static void shifting_clear(shifting *w) {
    for (size_t k = 0; k < w->count; k++)
        fmpq_clear(&w->record[k].at);
    free(w->record);
    outline_polygon_clear(&w->shifted);
}

static int is_short_edge(const polygon_edge *e, const polygon_edge *next) {
    return e->at[0] == next->at[0] && e->at[1] == next->at[1];
}

/* Let the last edge be the one before it too, if that has no length. */
static void join_last(outline_polygon *p, size_t first) {
    polygon_edge *e = &p->edge[p->count - 1];
    if (p->count > first + 1 && is_short_edge(e - 1, e)) {
        e[-1].arc = e->arc;
        p->count--;
    }
}

/* Make a ring of the edges from one on; drop them if they are less than three. */
static void close_shifted(outline_polygon *p, size_t first) {
    while (p->count > first + 1 && is_short_edge(&p->edge[p->count - 1], &p->edge[first]))
        p->count--;
    if (p->count < first + 3)
        p->count = first;
    for (size_t k = first; k < p->count; k++)
        p->edge[k].next = k + 1 < p->count ? k + 1 : first;
    if (p->count > first)
        p->first[p->ring_count++] = first;
}

/* Append a corner at x from the beginning of edge f, in shifts, moved by chance; `of`: the edge
 * that begins at it. */
static graze_status put_shifted(shifting *w, size_t first, size_t f, size_t of, double x,
                                double y) {
    outline_polygon *p = &w->shifted;
    const double to[2] = {x, y};
    TRY(polygon_edge_add(p, of, p->count));
    for (int i = 0; i < 2; i++) {
        w->chance = w->chance * 6364136223846793005UL + 1442695040888963407UL;
        double moved = w->loose * ((double)(w->chance >> 33) / 1073741824.0 - 1);
        p->edge[p->count - 1].at[i] = w->near->edge[f].at[i] + llround(w->shift * (to[i] + moved));
    }
    join_last(p, first);
    return GRAZE_OK;
}

/* The next edge that has a length; the edge itself if there is none. */
static size_t long_edge_after(const outline_polygon *p, size_t k) {
    size_t next = p->edge[k].next;
    while (next != k && is_short_edge(&p->edge[next], &p->edge[p->edge[next].next]))
        next = p->edge[next].next;
    return next;
}

/* The direction of an edge; returns its length. */
static double edge_direction(double *out, const outline_polygon *p, size_t k) {
    const slong *a = p->edge[k].at, *b = p->edge[p->edge[k].next].at;
    double x = (double)(b[0] - a[0]), y = (double)(b[1] - a[1]), length = hypot(x, y);
    out[0] = length > 0 ? x / length : 0;
    out[1] = length > 0 ? y / length : 0;
    return length;
}

/* The distance of a point from an edge. */
static double edge_distance(const slong *at, const outline_polygon *p, size_t k) {
    const slong *a = p->edge[k].at, *b = p->edge[p->edge[k].next].at;
    double u[2], length = edge_direction(u, p, k);
    double x = (double)(at[0] - a[0]), y = (double)(at[1] - a[1]), along = u[0] * x + u[1] * y;
    return along <= 0        ? hypot(x, y)
           : along >= length ? hypot((double)(at[0] - b[0]), (double)(at[1] - b[1]))
                             : fabs(u[0] * y - u[1] * x);
}

/* Append the corners at the end of edge e, which edge f follows: where the shifted edges are apart
 * the point at which their lines meet, or two of a cap at a sharp corner; where they overlap, that
 * point too if both are long, else both their ends, with a point near the corner between. */
static graze_status shift_corner(shifting *w, size_t first, size_t e, size_t f) {
    double u[2], v[2];
    double least = fmin(edge_direction(u, w->near, e), edge_direction(v, w->near, f));
    double cross = w->left * (u[0] * v[1] - u[1] * v[0]), dot = u[0] * v[0] + u[1] * v[1];
    double m[2] = {-w->left * u[1], w->left * u[0]}, n[2] = {-w->left * v[1], w->left * v[0]};
    double x = m[0] + n[0], y = m[1] + n[1];
    if (cross <= 0 ? dot >= 0 : w->shift * cross < least * (1 + dot) / 4)
        return put_shifted(w, first, f, f, x / (1 + dot), y / (1 + dot));
    int cap = cross <= 0 || dot < -0.9999;
    TRY(put_shifted(w, first, f, e, m[0] + cap * u[0], m[1] + cap * u[1]));
    if (!cap)
        TRY(put_shifted(w, first, f, e, x / 16, y / 16));
    return put_shifted(w, first, f, f, n[0] - cap * v[0], n[1] - cap * v[1]);
}

/* Append a record; the pointer is valid until the next one. */
static graze_status add_record(shift_record **out, shifting *w, size_t edge) {
    TRY(array_grow(w->near->context, &w->record, &w->capacity, w->count + 1, sizeof *w->record,
                   "the crossings of a polygon"));
    *out = &w->record[w->count++];
    **out = (shift_record){.edge = edge};
    fmpq_init(&(*out)->at);
    return context_work(w->near->context, 1000);
}

/* Shift all rings, and begin the records of their edges, which are to be within reach. */
static graze_status shift_rings(shifting *w) {
    const outline_polygon *near = w->near;
    outline_polygon *p = &w->shifted;
    double reach = 3 * near->distance - 1 - DISTANCE_ERROR;
    TRY(polygon_rings(p, near->ring_count));
    p->ring_count = 0;
    for (size_t r = 0; r < near->ring_count; r++) {
        size_t first = p->count, start = long_edge_after(near, near->first[r]), e = start, f;
        do {
            f = long_edge_after(near, e);
            if (f != e)
                TRY(shift_corner(w, first, e, f));
            e = f;
        } while (e != start);
        close_shifted(p, first);
    }
    for (size_t k = 0; k < p->count; k++) {
        shift_record *begin;
        TRY(add_record(&begin, w, k));
        w->wrong |= fmax(edge_distance(p->edge[k].at, near, p->edge[k].arc),
                         edge_distance(p->edge[p->edge[k].next].at, near, p->edge[k].arc)) > reach;
    }
    return GRAZE_OK;
}

/* Twice the area of a triangle, above 0 if r is on the left of pq. */
static void twice_area(fmpz_t out, const slong *p, const slong *q, const slong *r) {
    LOCAL(fmpz, other);
    fmpz_set_si(out, q[0] - p[0]);
    fmpz_mul_si(out, out, r[1] - p[1]);
    fmpz_set_si(other, q[1] - p[1]);
    fmpz_mul_si(other, other, r[0] - p[0]);
    fmpz_sub(out, out, other);
}

/* Insert the records of a crossing. One at an end of an edge, or with a third edge, is wrong. */
static graze_status cross_edges(void *state, size_t first, size_t second) {
    shifting *w = state;
    const polygon_edge *edge = w->shifted.edge, *x[2] = {&edge[first], &edge[second]};
    LOCAL_VEC(fmpz, side, 4); /* twice the areas of an edge and each end of the other one */
    LOCAL(fmpz, both);
    if (!polygon_edges_meet(&w->shifted, x[0], x[1]))
        return GRAZE_OK;
    for (int k = 0; k < 4; k++) {
        const polygon_edge *e = x[k / 2], *f = x[1 - k / 2], *end = k & 1 ? &edge[f->next] : f;
        twice_area(side + k, e->at, edge[e->next].at, end->at);
        w->wrong |= fmpz_is_zero(side + k);
    }
    for (int k = 0; k < 2 && !w->wrong; k++) {
        shift_record *r;
        const fmpz *start = side + 2 - 2 * k;
        TRY(add_record(&r, w, k ? second : first));
        fmpz_sub(both, start, start + 1);
        fmpq_set_fmpz_frac(&r->at, start, both);
        r->change = fmpz_sgn(side + 2 * k);
        size_t *link = &w->record[r->edge].after;
        while (*link && fmpq_cmp(&w->record[*link].at, &r->at) < 0)
            link = &w->record[*link].after;
        w->wrong |= *link && fmpq_equal(&w->record[*link].at, &r->at);
        r->after = *link;
        *link = w->count - 1;
    }
    return GRAZE_OK;
}

/* The winding number of all rings on the right side of the beginning of an edge. */
static int right_of_start(shifting *w, size_t edge) {
    const outline_polygon *p = &w->shifted;
    const slong *a = p->edge[edge].at, *b = p->edge[p->edge[edge].next].at;
    const slong middle[2] = {a[0] + b[0], a[1] + b[1]};
    int number = b[1] < a[1] || (b[1] == a[1] && b[0] > a[0]) ? -1 : 0;
    LOCAL(fmpq, half);
    fmpq_set_si(half, 1, 2);
    for (size_t r = 0; r < p->ring_count; r++)
        number += polygon_winding(p, p->first[r], middle, edge);
    for (size_t k = w->record[edge].after; k; k = w->record[k].after) {
        int order = fmpq_cmp(&w->record[k].at, half);
        number -= order < 0 ? w->record[k].change : 0;
        w->wrong |= order == 0;
    }
    return number;
}

/* Find the winding numbers along all rings. */
static graze_status find_windings(shifting *w) {
    const outline_polygon *p = &w->shifted;
    for (size_t r = 0; r < p->ring_count; r++) {
        size_t edge = p->first[r], k;
        int begun = right_of_start(w, edge), number = begun;
        do {
            w->record[edge].right = number;
            for (k = w->record[edge].after; k; k = w->record[k].after)
                w->record[k].right = number += w->record[k].change;
            edge = p->edge[edge].next;
        } while (edge != p->first[r]);
        w->wrong |= number != begun;
        TRY(context_work(p->context, 100 * p->count));
    }
    return GRAZE_OK;
}

/* Append a ring of parts with the number 0 on their right, from a record on: at a crossing it goes
 * on along the other edge. */
static graze_status take_ring(shifting *w, size_t start) {
    const outline_polygon *p = &w->shifted;
    outline_polygon *out = w->out;
    size_t first = out->count, n = p->count, k = start;
    LOCAL_VEC(fmpq, point, 2);
    do {
        shift_record *r = &w->record[k];
        const polygon_edge *e = &p->edge[r->edge];
        if (r->used || r->right) {
            w->wrong = 1;
            return GRAZE_OK;
        }
        r->used = 1;
        TRY(polygon_edge_add(out, e->arc, out->count));
        for (int i = 0; i < 2; i++) {
            fmpq_mul_si(point + i, &r->at, p->edge[e->next].at[i] - e->at[i]);
            fmpq_add_si(point + i, point + i, e->at[i]);
            fmpq_div_2exp(point + i, point + i, p->places);
        }
        TRY(polygon_edge_start(out, out->count - 1, point));
        join_last(out, first);
        k = r->after ? n + ((r->after - n) ^ 1) : e->next;
    } while (k != start);
    close_shifted(out, first);
    return GRAZE_OK;
}

/* Is an edge clear of one of the rings near the outline? */
static graze_status check_clear(void *state, size_t edge, size_t other) {
    shifting *w = state;
    const outline_polygon *p = w->out, *q = w->near;
    const slong *a = p->edge[edge].at, *b = p->edge[p->edge[edge].next].at;
    const slong *c = q->edge[other].at, *d = q->edge[q->edge[other].next].at;
    double apart = fmin(fmin(edge_distance(a, q, other), edge_distance(b, q, other)),
                        fmin(edge_distance(c, p, edge), edge_distance(d, p, edge)));
    w->wrong |= apart < q->distance + DISTANCE_ERROR ||
                (polygon_turn(a, b, c) * polygon_turn(a, b, d) <= 0 &&
                 polygon_turn(c, d, a) * polygon_turn(c, d, b) <= 0);
    return GRAZE_OK;
}

/* Is the winding number of all rings of p about the first corner of each ring of q this one? */
static int all_around(const outline_polygon *p, const outline_polygon *q, int number) {
    int same = 1;
    for (size_t r = 0; r < q->ring_count; r++) {
        const slong *at = q->edge[q->first[r]].at, twice[2] = {2 * at[0], 2 * at[1]};
        int around = 0;
        for (size_t s = 0; s < p->ring_count; s++)
            around += polygon_winding(p, p->first[s], twice, p->count);
        same &= around == number;
    }
    return same;
}

/* Make the rings of one attempt. */
static graze_status attempt_beside(shifting *w) {
    outline_polygon *out = w->out;
    int clear = 1;
    TRY(shift_rings(w));
    TRY(polygon_pairs(&w->shifted, NULL, 0, cross_edges, w));
    TRY(find_windings(w));
    TRY(polygon_rings(out, w->count));
    out->ring_count = 0;
    for (size_t k = 0; k < w->count && !w->wrong; k++)
        if (w->record[k].right == 0 && !w->record[k].used)
            TRY(take_ring(w, k));
    if (w->wrong)
        return GRAZE_OK;
    TRY(polygon_meetings(&clear, out));
    TRY(polygon_pairs(out, w->near, (slong)w->near->distance, check_clear, w));
    w->wrong |= !clear;
    w->wrong |= !all_around(out, w->near, w->left < 0);
    w->wrong |= !all_around(w->near, out, w->left > 0);
    return polygon_nest(out);
}

graze_status outline_polygon_beside(outline_polygon *out, const graze_outline *o,
                                    graze_context *context, double within,
                                    graze_polygon_side side) {
    if (side == GRAZE_POLYGON_NEAR)
        return outline_polygon_make(out, o, context, within);
    ZEROED(outline_polygon, near);
    within = fmin(within / 4, ldexp(1, outline_exponent(o) - 2));
    if (ldexp(within, 52 - outline_exponent(o)) >= LEAST_DISTANCE)
        TRY(polygon_parts(&near, o, context, within));
    for (int k = 0; k < ATTEMPTS && near.distance >= LEAST_DISTANCE; k++) {
        outline_polygon_clear(out);
        *out = (outline_polygon){.o = o, .context = context, .places = near.places};
        ZEROED(shifting, w);
        w = (shifting){.near = &near,
                       .shifted = *out,
                       .out = out,
                       .left = side == GRAZE_POLYGON_INSIDE ? 1 : -1,
                       .shift = 2 * near.distance,
                       .loose = k / 512.0};
        TRY(attempt_beside(&w));
        if (!w.wrong)
            return GRAZE_OK;
    }
    return context_fail(context, GRAZE_ELIMIT,
                        "a polygon %s the outline: none is found whose coordinates are doubles",
                        side == GRAZE_POLYGON_INSIDE ? "inside" : "outside");
}
