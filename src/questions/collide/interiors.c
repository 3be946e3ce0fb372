/* The interiors meet if an edge passes through a simplex, a component is inside the other solid, or
 * the open cones at a common point meet. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "questions/collide/features.h"

/** A common point, the key of its vertex or its two edges, and a pair of simplices whose common
 * part has the point as a corner. */
typedef struct meeting_point {
    corner_kind kind;
    uint32_t key[4];
    near_pair simplices;
    common_corner corner;
} meeting_point;

typedef struct looker {
    placing *p;
    int crossing; /* an edge passes through a simplex: the points are incomplete */
    size_t count, capacity;
    meeting_point *item;
} looker;

static int compare_meetings(const void *left, const void *right) {
    const meeting_point *a = left, *b = right;
    if (a->kind != b->kind)
        return a->kind < b->kind ? -1 : 1;
    for (int i = 0; i < 4; i++)
        if (a->key[i] != b->key[i])
            return a->key[i] < b->key[i] ? -1 : 1;
    return 0;
}

static void set_key(meeting_point *m, const placing *p) {
    if (m->kind == CORNER_EDGES) {
        for (int side = 0; side < 2; side++)
            simplex_edge(m->key + 2 * side, placing_solid(p, (pair_side)side),
                         simplex_of(m->simplices, (pair_side)side), m->corner.at[side]);
        return;
    }
    pair_side side = m->kind == CORNER_MOVING ? SIDE_MOVING : SIDE_FIXED;
    const simplices *cut = &placing_solid(p, side)->cut;
    m->key[0] = m->key[1] = cut->item[simplex_of(m->simplices, side)].vertex[m->corner.at[side]];
}

static void add_meeting_point(looker *l, near_pair simplices, const common_corner *corner) {
    if (!PLACING_ROOM(l->p, l, "common points"))
        return;
    meeting_point *m = &l->item[l->count++];
    *m = (meeting_point){.kind = corner->kind, .simplices = simplices, .corner = *corner};
    set_key(m, l->p);
}

/* Gather the common points of all pairs, until an edge passes through a simplex. */
static void gather_points(looker *l, const near_list *near) {
    common_points found;
    for (size_t k = 0; k < near->count && !l->p->status; k++) {
        common_points_find(&found, l->p, near->item[k]);
        if (found.crossing && !l->p->status) {
            l->crossing = 1;
            return;
        }
        for (int c = 0; c < found.count; c++)
            add_meeting_point(l, near->item[k], &found.item[c]);
        placing_poll(l->p, k);
    }
    if (l->count)
        qsort(l->item, l->count, sizeof *l->item, compare_meetings);
}

/* Is a vertex one of the common points? */
static int is_common(const looker *l, pair_side side, uint32_t vertex) {
    meeting_point m = {.kind = side == SIDE_MOVING ? CORNER_MOVING : CORNER_FIXED,
                       .key = {vertex, vertex, 0, 0}};
    return l->count && bsearch(&m, l->item, l->count, sizeof *l->item, compare_meetings) != NULL;
}

/* Is a component of one boundary, which does not meet the other boundary, in the other solid's
 * interior? One vertex of the component tells. */
static int finds_inside(looker *l, placing *rational, pair_side side) {
    const simplices *cut = &placing_solid(l->p, side)->cut;
    FREED(unsigned char, seen, calloc(cut->component_count, 1));
    size_t left = cut->component_count;
    int found = 0;
    if (!seen)
        l->p->status = context_fail(l->p->context, GRAZE_ESYSTEM, "out of memory for %zu parts",
                                    cut->component_count);
    for (size_t k = 0; left && k < cut->count && seen && !found && !l->p->status; k++) {
        uint32_t vertex = cut->item[k].vertex[0];
        if (seen[cut->item[k].component])
            continue;
        seen[cut->item[k].component] = 1;
        left--;
        found = !is_common(l, side, vertex) && placing_in_interior_then(rational, side, vertex);
        if (rational->status)
            l->p->status = rational->status;
    }
    return found;
}

/* Set the barycentric shares of an edge's ends at its crossing with another edge: the share of one
 * end is the other end's distance from the other triangle's plane or, within that plane, from the
 * other edge. */
static void set_shares(fmpz_poly_struct share[2], placing *p, const meeting_point *m,
                       pair_side side, const uint32_t end[2]) {
    pair_side other = (pair_side)!side;
    uint32_t simplex = simplex_of(m->simplices, other);
    for (int k = 0; k < 2; k++) {
        placing_plane(&share[!k], p, other, simplex, end[k]);
        if (placing_sign(p, &share[!k]) == 0)
            placing_side(&share[!k], p, other, simplex, m->corner.at[other], end[k]);
        if (placing_sign(p, &share[!k]) < 0)
            fmpz_poly_neg(&share[!k], &share[!k]);
    }
    /* A placed vertex is homogeneous: a form's value there has the factor of the vertex's weight.
     */
    for (int k = 0; k < 2; k++) {
        const trajectory *c = placing_vertex(p, side, end[k]);
        if (c)
            fmpz_poly_mul(&share[k], &share[k], &c->x[p->pair->motion->dimension]);
    }
}

/* Gather the sectors of one solid at a common point. */
static void gather_sectors(sectors_about *out, placing *p, const meeting_point *m, pair_side side) {
    star about = {0};
    uint32_t end[2];
    LOCAL_VEC(fmpz_poly, share, 2);
    memcpy(end, m->key, sizeof end);
    if (m->kind == CORNER_EDGES) {
        memcpy(end, m->key + 2 * side, sizeof end);
        set_shares(share, p, m, side, end);
    }
    star_find(&about, p, side, end, share);
    for (size_t k = 0; k < about.count && !p->status; k++)
        sectors_about_add(out, p, side, about.item[k].simplex, about.item[k].zero);
    free(about.item);
}

/* Gather the sectors of one solid at a vertex of the other: each simplex that holds the vertex is
 * in some pair with it. */
static void gather_sectors_of_pairs(sectors_about *out, placing *p, const meeting_point *m,
                                    size_t count, pair_side side) {
    for (size_t k = 0; k < count && !p->status; k++) {
        uint32_t simplex = simplex_of(m[k].simplices, side);
        int seen = 0;
        for (size_t j = 0; j < k && !seen; j++)
            seen = simplex == simplex_of(m[j].simplices, side);
        if (!seen)
            sectors_about_add(out, p, side, simplex, m[k].corner.zero[side]);
    }
}

/* Do the open cones meet at a common point, given by the first `count` entries of the list? */
static int cones_meet_at(placing *p, const meeting_point *m, size_t count) {
    sectors_about about[2] = {{0}, {0}};
    for (int side = 0; side < 2; side++)
        if (m->kind == CORNER_EDGES || (int)m->kind == side)
            gather_sectors(&about[side], p, m, (pair_side)side);
        else
            gather_sectors_of_pairs(&about[side], p, m, count, (pair_side)side);
    int found = !p->status && open_cones_meet(p, &about[0], &about[1]);
    sectors_about_clear(&about[0]);
    sectors_about_clear(&about[1]);
    return found;
}

static int cones_meet(looker *l) {
    int found = 0;
    for (size_t k = 0, end; k < l->count && !found && !l->p->status; k = end) {
        for (end = k + 1; end < l->count && compare_meetings(&l->item[k], &l->item[end]) == 0;)
            end++;
        found = cones_meet_at(l->p, &l->item[k], end - k);
        if (!l->p->status)
            l->p->status = context_poll(l->p->context);
    }
    return found;
}

graze_state interiors_look(placing *p, const near_list *near, placing *before) {
    looker l = {.p = p};
    placing *rational = before ? before : p;
    if (p->near) {
        graze_state state = features_look(p, near);
        int held = state != GRAZE_STATE_I && !p->status &&
                   (finds_inside(&l, p, SIDE_MOVING) || finds_inside(&l, p, SIDE_FIXED));
        return held ? GRAZE_STATE_I : state;
    }
    gather_points(&l, near);
    int meet =
        l.crossing || (!p->status && (finds_inside(&l, rational, SIDE_MOVING) ||
                                      finds_inside(&l, rational, SIDE_FIXED) || cones_meet(&l)));
    free(l.item);
    return meet ? GRAZE_STATE_I : l.count ? GRAZE_STATE_B : GRAZE_STATE_O;
}
