/* Joins the pieces of edges that boxes have cut, and numbers the vertices.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _GNU_SOURCE /* qsort_r */
#include "input/planar/walk.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

void flat_points_clear(flat_points *p) {
    for (size_t k = 0; k < 3 * p->count; k++)
        fmpq_clear(p->at + k);
    free(p->at);
    free(p->number);
    free(p->first);
}

void flat_edges_clear(flat_edges *e) {
    free(e->item);
}

static int line_order(const fmpz *a, const fmpz *b) {
    int order = 0;
    for (int k = 0; k < LINE_FORM && order == 0; k++)
        order = fmpz_cmp(a + k, b + k);
    return order;
}

#define DIFFERENCE(member)                                                                         \
    if (a->member != b->member)                                                                    \
    return a->member < b->member ? -1 : 1

/* Order pieces by line and facet. */
static int facet_order(const flat_piece *a, const flat_piece *b, const fmpz *lines) {
    int order = line_order(lines + LINE_FORM * a->line, lines + LINE_FORM * b->line);
    if (order)
        return order;
    DIFFERENCE(plane);
    DIFFERENCE(facing);
    DIFFERENCE(along);
    return 0;
}

static int piece_order(const void *left, const void *right, void *lines) {
    const flat_piece *a = left, *b = right;
    int order = facet_order(a, b, lines);
    return order ? order : fmpq_cmp(&a->from, &b->from);
}

static int flat_edge_order(const void *left, const void *right) {
    const flat_edge *a = left, *b = right;
    DIFFERENCE(plane);
    DIFFERENCE(facing);
    DIFFERENCE(from);
    DIFFERENCE(to);
    return 0;
}

/* Join sorted pieces of one line and facet that meet or overlap. */
static void join_pieces(flat_pieces *p, const fmpz *lines) {
    size_t kept = 0;
    for (size_t k = 0; k < p->count; k++) {
        flat_piece *last = kept ? &p->item[kept - 1] : NULL, *next = &p->item[k];
        if (last && facet_order(last, next, lines) == 0 && fmpq_cmp(&next->from, &last->to) <= 0) {
            if (fmpq_cmp(&next->to, &last->to) > 0)
                fmpq_swap(&last->to, &next->to);
            continue;
        }
        flat_piece held = p->item[kept];
        p->item[kept++] = *next;
        if (kept <= k)
            *next = held;
    }
    for (size_t k = kept; k < p->count; k++) {
        fmpq_clear(&p->item[k].from);
        fmpq_clear(&p->item[k].to);
    }
    p->count = kept;
}

static int place_order(const void *left, const void *right) {
    const fmpq *const *a = left, *const *b = right;
    return fmpq_cmp(*a, *b);
}

/* Append the point of a line at a place. */
static graze_status append_place(flat_points *p, flat_walk *w, const fmpz *line, const fmpz *foot,
                                 const fmpq *place) {
    TRY(ARRAY_GROW(w->context, p->at, p->capacity, 3 * p->count + 3, "the vertices of a solid"));
    fmpq *x = p->at + 3 * p->count++;
    for (int i = 0; i < 3; i++) {
        fmpq_init(x + i);
        fmpq_mul_fmpz(x + i, place, line + i);
        fmpq_add_fmpz(x + i, x + i, foot + i);
        fmpq_div_fmpz(x + i, x + i, foot + 3);
    }
    return GRAZE_OK;
}

/* Add the edges of the pieces [0, count) of one line. The vertices of edges are numbers of points.
 */
static graze_status add_line(flat_edges *out, flat_points *points, flat_walk *w,
                             const flat_piece *piece, size_t count) {
    const fmpz *line = w->lines.item + LINE_FORM * piece->line;
    LOCAL_VEC(fmpz, foot, 4);
    FREED(const fmpq *, place, NULL);
    TRY(MAKE_ARRAY(w->context, place, 2 * count, "%zu edges", count));
    for (size_t k = 0; k < count; k++) {
        place[2 * k] = &piece[k].from;
        place[2 * k + 1] = &piece[k].to;
    }
    size_t places = array_sort_once(place, 2 * count, sizeof *place, place_order);
    size_t first = points->count;
    flat_foot(foot, line);
    for (size_t k = 0; k < places; k++)
        TRY(append_place(points, w, line, foot, place[k]));
    for (size_t k = 0; k < count; k++) {
        const flat_piece *p = &piece[k];
        const fmpq *begin = &p->from;
        size_t at = array_first(&begin, place, places, sizeof *place, place_order);
        for (; fmpq_cmp(place[at], &p->to) < 0; at++) {
            TRY(LIST_GROW(w->context, out, "the edges of a solid"));
            size_t a = first + at, b = first + at + 1;
            out->item[out->count++] =
                (flat_edge){p->plane, p->facing, p->along > 0 ? a : b, p->along > 0 ? b : a};
        }
    }
    return context_work(w->context, 16 * places);
}

static int point_order(const void *left, const void *right) {
    const fmpq *const *a = left, *const *b = right;
    return vector_compare(*a, *b, 3);
}

/* Number the vertices. */
static graze_status number_points(flat_points *p, graze_context *context) {
    size_t n = p->count;
    FREED(const fmpq *, entry, NULL);
    TRY(MAKE_ARRAY(context, entry, n + 1, "%zu vertices", n));
    TRY(MAKE_ARRAY(context, p->number, n + 1, "%zu vertices", n));
    TRY(MAKE_ARRAY(context, p->first, n + 1, "%zu vertices", n));
    for (size_t k = 0; k < n; k++)
        entry[k] = p->at + 3 * k;
    qsort(entry, n, sizeof *entry, point_order);
    for (size_t k = 0; k < n; k++) {
        size_t point = (size_t)(entry[k] - p->at) / 3;
        if (k == 0 || point_order(&entry[k - 1], &entry[k]) != 0)
            p->first[p->vertices++] = point;
        p->number[point] = p->vertices - 1;
    }
    return GRAZE_OK;
}

/* A vertex inside an edge, which it cuts. */
typedef struct split {
    size_t low, high, at; /* vertices, the edge's ends ascending */
} split;

typedef struct splits {
    size_t count, capacity;
    split *item;
} splits;

static void splits_clear(splits *s) {
    free(s->item);
}

static int split_order(const void *left, const void *right) {
    const split *a = left, *b = right;
    DIFFERENCE(low);
    DIFFERENCE(high);
    DIFFERENCE(at);
    return 0;
}

/* Whether vertex v, whose number is between those of a and b, is on the segment from a to b. */
static int is_on(const flat_points *p, size_t a, size_t b, size_t v) {
    const fmpq *from = p->at + 3 * p->first[a], *to = p->at + 3 * p->first[b];
    const fmpq *x = p->at + 3 * p->first[v];
    for (int i = 1; i < 3; i++)
        if (fmpq_cmp(x + i, from + i) * fmpq_cmp(x + i, to + i) > 0)
            return 0;
    return vector_collinear(from, to, x);
}

/* Find the vertices of a facet's edges that are inside another one of them. */
static graze_status find_splits(splits *out, const flat_points *points, graze_context *context,
                                const flat_edge *edges, size_t count) {
    for (size_t k = 0; k < count; k++) {
        size_t low = edges[k].from < edges[k].to ? edges[k].from : edges[k].to;
        size_t high = edges[k].from + edges[k].to - low, last = high;
        size_t i = array_first(&(flat_edge){.from = low + 1}, edges, count, sizeof *edges,
                               flat_from_order);
        for (; i < count && edges[i].from < high; i++) {
            size_t v = edges[i].from;
            TRY(context_work(context, 4));
            if (v == last || !is_on(points, low, high, v))
                continue;
            TRY(LIST_GROW(context, out, "the edges of a solid"));
            out->item[out->count++] = (split){low, high, v};
            last = v;
        }
    }
    return GRAZE_OK;
}

/* Cut edges at the vertices inside them; the parts are appended. */
static graze_status cut_edges(flat_edges *out, graze_context *context, splits *s) {
    s->count = array_sort_once(s->item, s->count, sizeof *s->item, split_order);
    for (size_t k = 0, count = out->count; k < count; k++) {
        flat_edge edge = out->item[k];
        int up = edge.from < edge.to;
        split key = {up ? edge.from : edge.to, up ? edge.to : edge.from, 0};
        size_t i = array_first(&key, s->item, s->count, sizeof *s->item, split_order);
        for (; i < s->count && s->item[i].low == key.low && s->item[i].high == key.high; i++) {
            TRY(LIST_GROW(context, out, "the edges of a solid"));
            flat_edge *part = &out->item[out->count++];
            *part = edge;
            *(up ? &part->to : &part->from) = s->item[i].at;
            *(up ? &edge.from : &edge.to) = s->item[i].at;
        }
        out->item[k] = edge;
    }
    return GRAZE_OK;
}

/* In space cut edges where another vertex of a facet is inside one of its edges. */
static graze_status split_touched(flat_edges *out, const flat_points *points, flat_walk *w) {
    ZEROED(splits, found);
    for (size_t k = 0, end; k < out->count && w->dimension == 3; k = end) {
        end = flat_facet_end(out, k);
        TRY(find_splits(&found, points, w->context, out->item + k, end - k));
    }
    if (found.count == 0)
        return GRAZE_OK;
    TRY(cut_edges(out, w->context, &found));
    qsort(out->item, out->count, sizeof *out->item, flat_edge_order);
    return GRAZE_OK;
}

size_t flat_facet_end(const flat_edges *edges, size_t begin) {
    const flat_edge *first = &edges->item[begin];
    size_t end = begin + 1;
    while (end < edges->count && edges->item[end].plane == first->plane &&
           edges->item[end].facing == first->facing)
        end++;
    return end;
}

int flat_from_order(const void *left, const void *right) {
    const flat_edge *a = left, *b = right;
    DIFFERENCE(from);
    return 0;
}

graze_status flat_edges_find(flat_edges *out, flat_points *points, flat_walk *w) {
    flat_pieces *p = &w->pieces;
    fmpz *lines = w->lines.item;
    qsort_r(p->item, p->count, sizeof *p->item, piece_order, lines);
    join_pieces(p, lines);
    for (size_t k = 0, end; k < p->count; k = end) {
        for (end = k + 1; end < p->count && line_order(lines + LINE_FORM * p->item[end].line,
                                                       lines + LINE_FORM * p->item[k].line) == 0;)
            end++;
        TRY(add_line(out, points, w, p->item + k, end - k));
    }
    TRY(number_points(points, w->context));
    for (size_t k = 0; k < out->count; k++) {
        out->item[k].from = points->number[out->item[k].from];
        out->item[k].to = points->number[out->item[k].to];
    }
    qsort(out->item, out->count, sizeof *out->item, flat_edge_order);
    return split_touched(out, points, w);
}
