/* Times of incidences are roots of plane forms at vertices, and of determinants of edges.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Adjacent simplices share vertices and edges, so duplicates are removed first.
 */
#include <stdlib.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/isolate.h"
#include "base/number/order.h"
#include "base/number/simplest.h"
#include "questions/collide/near_pairs.h"

/** A vertex and a simplex of the other solid, or two edges, with a pair of simplices around them.
 */
typedef struct meeting_cells {
    uint32_t key[4];
    near_pair simplices;
    int k, l; /* the corner's number k, or the numbers of both sides */
} meeting_cells;

typedef struct cell_list {
    size_t count, capacity;
    meeting_cells *item;
} cell_list;

typedef struct finder {
    algebraic_list found; /* unordered */
    placing *p;
    const near_list *near;
    const control_maps *maps;
    double error; /* of error_of_places */
    const dyadic_interval *interval;
} finder;

static int compare_cells(const void *left, const void *right) {
    const meeting_cells *a = left, *b = right;
    for (int i = 0; i < 4; i++)
        if (a->key[i] != b->key[i])
            return a->key[i] < b->key[i] ? -1 : 1;
    return 0;
}

static void add_meeting(cell_list *list, finder *f, meeting_cells item) {
    if (PLACING_ROOM(f->p, list, "cells that may meet"))
        list->item[list->count++] = item;
}

static void leave_each_once(cell_list *list) {
    list->count = array_sort_once(list->item, list->count, sizeof *list->item, compare_cells);
}

/* Gather, for each pair, the vertices of one simplex with the other simplex, which is of `side`. */
static void gather_vertices(cell_list *out, finder *f, pair_side side) {
    const graze_solid *of = placing_solid(f->p, (pair_side)!side);
    for (size_t i = 0; i < f->near->count; i++)
        for (int k = 0; k < of->input.dimension; k++) {
            near_pair s = f->near->item[i];
            uint32_t vertex = of->cut.item[simplex_of(s, (pair_side)!side)].vertex[k];
            add_meeting(out, f, (meeting_cells){{vertex, simplex_of(s, side), 0, 0}, s, k, 0});
        }
    leave_each_once(out);
}

static void gather_edges(cell_list *out, finder *f) {
    for (size_t i = 0; i < f->near->count; i++)
        for (int k = 0; k < 3; k++)
            for (int l = 0; l < 3; l++) {
                meeting_cells m = {{0, 0, 0, 0}, f->near->item[i], k, l};
                simplex_edge(m.key, f->p->pair->moving, m.simplices.moving, k);
                simplex_edge(m.key + 2, f->p->pair->fixed, m.simplices.fixed, l);
                add_meeting(out, f, m);
            }
    leave_each_once(out);
}

/* Append the roots of q, not zero, in the interval. */
static void find_times(algebraic_list *roots, finder *f, const fmpz_poly_t q) {
    if (!f->p->status && !certainly_rootless(q, f->interval))
        f->p->status = algebraic_roots(roots, f->p->context, q, f->interval);
}

static void note_time(finder *f, const algebraic *time) {
    algebraic_set(algebraic_list_append(&f->found), time);
}

/* Are some corners of both simplices certainly apart during the whole interval? */
static int runs_apart(const finder *f, corner_run moving, corner_run fixed) {
    return corners_apart(f->p->pair, f->maps, moving, fixed, f->error);
}

/* Note the times at which the vertex is in the simplex or, if it is always in the simplex's plane,
 * the times at which it may change its cell in that plane. */
static void meet_vertex(finder *f, pair_side side, const meeting_cells *m) {
    int d = f->p->pair->motion->dimension;
    near_pair s = m->simplices;
    unsigned zero;
    int moves = side == SIDE_FIXED;
    if (runs_apart(f, (corner_run){s.moving, moves ? m->k : 0, moves ? 1 : d},
                   (corner_run){s.fixed, moves ? 0 : m->k, moves ? d : 1}))
        return;
    LOCAL(fmpz_poly, q);
    HELD(algebraic_list, roots);
    placing_plane(q, f->p, side, m->key[1], m->key[0]);
    if (!fmpz_poly_is_zero(q))
        find_times(&roots, f, q);
    else
        for (int k = 0; k < d; k++) {
            placing_side(q, f->p, side, m->key[1], k, m->key[0]);
            if (!fmpz_poly_is_zero(q))
                find_times(&roots, f, q);
        }
    for (size_t k = 0; k < roots.count && !f->p->status; k++) {
        placing_set_time(f->p, &roots.item[k]);
        if (placing_inside(&zero, f->p, side, m->key[1], m->key[0]))
            note_time(f, &roots.item[k]);
    }
}

/* Do two edges, whose lines are coplanar at the time, cross inside both? Only the signs of the
 * edges' ends at the other triangle's plane are found. */
static int cross_then(placing *p, const meeting_cells *m) {
    int plane[2][3] = {{0}, {0}};
    near_pair s = m->simplices;
    for (int side = 0; side < 2; side++) {
        pair_side own = (pair_side)side, other = (pair_side)!side;
        const uint32_t *vertex = placing_solid(p, own)->cut.item[simplex_of(s, own)].vertex;
        int first = own == SIDE_MOVING ? m->k : m->l, second = (first + 1) % 3;
        plane[own][first] = placing_plane_sign(p, other, simplex_of(s, other), vertex[first]);
        plane[own][second] = placing_plane_sign(p, other, simplex_of(s, other), vertex[second]);
        if (own == SIDE_MOVING && plane[own][first] * plane[own][second] > 0)
            return 0;
    }
    return edges_cross(p, s, m->k, m->l, plane);
}

static void meet_two_edges(finder *f, const meeting_cells *m) {
    uint32_t moving[2], fixed[2];
    if (runs_apart(f, (corner_run){m->simplices.moving, m->k, 2},
                   (corner_run){m->simplices.fixed, m->l, 2}))
        return;
    simplex_side(moving, f->p->pair->moving, m->simplices.moving, m->k);
    simplex_side(fixed, f->p->pair->fixed, m->simplices.fixed, m->l);
    LOCAL(fmpz_poly, q);
    HELD(algebraic_list, roots);
    placing_edges(q, f->p, moving, fixed);
    if (!fmpz_poly_is_zero(q))
        find_times(&roots, f, q);
    for (size_t k = 0; k < roots.count && !f->p->status; k++) {
        placing_set_time(f->p, &roots.item[k]);
        if (cross_then(f->p, m) && !f->p->status)
            note_time(f, &roots.item[k]);
    }
}

/* Note the times at which two features are at the clearance, unless they always are: where edges
 * are parallel then, their ends tell (proofs/collision.md C132). */
static void meet_features(finder *f, const feature_pair *features) {
    unsigned zero[2];
    if (runs_apart(f, features->of[SIDE_MOVING], features->of[SIDE_FIXED]))
        return;
    HELD(stationary, s, f->p, features);
    HELD(algebraic_list, roots);
    if (!fmpz_poly_is_zero(s.equation))
        find_times(&roots, f, s.equation);
    for (size_t k = 0; k < roots.count && !f->p->status; k++) {
        placing_set_time(f->p, &roots.item[k]);
        int found = s.count > 1 && placing_sign(f->p, s.gram) == 0
                        ? edge_ends_touch(f->p, features)
                        : stationary_inside(zero, f->p, &s);
        if (found && !f->p->status)
            note_time(f, &roots.item[k]);
    }
}

static void meet_all_features(finder *f) {
    int d = f->p->pair->motion->dimension;
    ZEROED(feature_list, list);
    feature_kind kind;
    for (int k = 0; feature_kind_next(&kind, k, d) && !feature_kind_pierces(kind, d); k++) {
        features_gather(&list, f->p, f->near, kind);
        for (size_t i = 0; i < list.count && !f->p->status; i++)
            meet_features(f, &list.item[i]);
    }
}

/* Append the found times to `out`, sorted, without duplicates. */
static void order_times(algebraic_list *out, finder *f) {
    size_t n = f->found.count;
    FREED(algebraic *, order, malloc((n ? n : 1) * sizeof(algebraic *)));
    if (!order && !f->p->status)
        f->p->status =
            context_fail(f->p->context, GRAZE_ESYSTEM, "out of memory for a list of %zu times", n);
    for (size_t k = 0; order && k < n; k++)
        order[k] = &f->found.item[k];
    if (!f->p->status)
        f->p->status = algebraic_sort_once(order, &n, f->p->context, NULL, NULL);
    for (size_t k = 0; k < n && !f->p->status; k++)
        algebraic_set(algebraic_list_append(out), order[k]);
}

graze_status incidences_find(algebraic_list *out, placing *p, const near_list *near,
                             const control_maps *maps, const dyadic_interval *interval) {
    finder f = {.p = p, .near = near, .maps = maps, .interval = interval};
    f.error = error_of_places(p->pair, maps);
    cell_list list = {0};
    algebraic_list_init(&f.found);
    if (p->near)
        meet_all_features(&f);
    for (int side = 0; side < 2 && !p->status && !p->near; side++) {
        list.count = 0;
        gather_vertices(&list, &f, (pair_side)side);
        for (size_t k = 0; k < list.count && !p->status; k++)
            meet_vertex(&f, (pair_side)side, &list.item[k]);
    }
    list.count = 0;
    if (p->pair->motion->dimension == 3 && !p->status && !p->near)
        gather_edges(&list, &f);
    for (size_t k = 0; k < list.count && !p->status; k++)
        meet_two_edges(&f, &list.item[k]);
    if (!p->status)
        order_times(out, &f);
    free(list.item);
    algebraic_list_clear(&f.found);
    return p->status;
}
