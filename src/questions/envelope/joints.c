/* Joints between moments: finds at each vertex and edge the patches
 * that end at one place. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "questions/envelope/patch_ends.h"

/* The places of one vertex or edge, between two moments. `first_joint` is the number of this cell's
 * first joint. */
typedef struct joining {
    graze_patches *p;
    graze_context *context;
    const patch_place *place;
    size_t count, from, to, first_joint;
    numbers cuts, set;
} joining;

static int is_active(const joining *j, const patch_place *place) {
    const patch *item = &j->p->item[place->patch];
    return item->from <= j->from && j->to <= item->to;
}

/* The form of the joint of the set's patches: a slice or a run counts once, a whole facet as more
 * than two, a point not. */
static graze_chain_form form_of(const joining *j) {
    int surfaces = 0;
    for (size_t k = 0; k < j->set.count; k++) {
        graze_curve_kind kind = j->p->item[j->set.item[k]].facts.kind;
        surfaces += kind == GRAZE_CURVE_WHOLE ? 3 : kind != GRAZE_CURVE_POINT;
    }
    return j->p->envelope->cells.dimension == 2 || surfaces == 0 ? GRAZE_CHAIN_NONE
           : surfaces == 1                                       ? GRAZE_CHAIN_OPEN
           : surfaces == 2                                       ? GRAZE_CHAIN_CLOSED
                                                                 : GRAZE_CHAIN_BRANCHING;
}

/* Extend the joint of these patches that ends at moment `from`, if there is one; returns 0 if there
 * is none. */
static int extends_joint(const joining *j) {
    for (size_t k = j->first_joint; k < j->p->joint_count; k++) {
        patch_joint *old = &j->p->joint[k];
        size_t same = 0;
        if (old->to != j->from || old->count != j->set.count)
            continue;
        while (same < old->count && j->p->member[old->first + same] == j->set.item[same])
            same++;
        if (same == old->count) {
            old->to = j->to;
            return 1;
        }
    }
    return 0;
}

/* Add a joint of the set if the set has two or more patches or, in E^3, one slice or run. */
static graze_status emit_set(joining *j) {
    const cell_complex *c = &j->p->envelope->cells;
    numbers_sort(&j->set);
    graze_chain_form form = form_of(j);
    if ((j->set.count < 2 && form == GRAZE_CHAIN_NONE) || extends_joint(j))
        return GRAZE_OK;
    const graze_cell *cell =
        j->place->is_edge ? &c->edge[j->place->cell].name : &c->vertex[j->place->cell].name;
    return joint_add(j->p, j->context, cell, form, j->from, j->to, &j->set);
}

/* Join the patches at a vertex, whose places have no facet; or whole facets that contain an edge
 * with runs along all of it. */
static graze_status join_all_of_cell(joining *j) {
    int whole = !j->place->is_edge;
    j->set.count = 0;
    for (size_t k = 0; k < j->count; k++)
        if (j->place[k].facet == SIZE_MAX && is_active(j, &j->place[k])) {
            whole |= j->p->item[j->place[k].patch].facts.kind == GRAZE_CURVE_WHOLE;
            TRY(members_add(&j->set, j->context, j->place[k].patch));
        }
    return whole ? emit_set(j) : GRAZE_OK;
}

/* The place on the edge where g of a facet vanishes: 0 at vertex u, 1 at v. */
static void place_along(fmpq_t out, const snapshot *s, size_t edge, size_t facet) {
    const cell_complex *c = &s->e->cells;
    size_t d = (size_t)s->dimension;
    LOCAL(fmpq, other);
    snapshot_g(out, s, facet, c->at + c->edge[edge].u * d);
    snapshot_g(other, s, facet, c->at + c->edge[edge].v * d);
    fmpq_sub(other, out, other);
    fmpq_div(out, out, other);
}

/* Add the joint of the patches that end at the place of entry `first`; mark their entries in
 * `done`. */
static graze_status join_at_place(joining *j, const snapshot *s, size_t first,
                                  unsigned char *done) {
    LOCAL_VEC(fmpq, here, 2);
    fmpq *there = here + 1;
    place_along(here, s, j->place->cell, j->place[first].facet);
    j->set.count = 0;
    for (size_t k = first; k < j->count; k++) {
        if (done[k] || j->place[k].facet == SIZE_MAX || !is_active(j, &j->place[k]))
            continue;
        place_along(there, s, j->place->cell, j->place[k].facet);
        if (!fmpq_equal(here, there))
            continue;
        done[k] = 1;
        TRY(members_add(&j->set, j->context, j->place[k].patch));
    }
    return emit_set(j);
}

static graze_status join_within_edge(joining *j) {
    ZEROED(snapshot, s);
    FREED(unsigned char, done, calloc(j->count, 1));
    if (!done)
        return context_fail(j->context, GRAZE_ESYSTEM, "out of memory for the joints of patches");
    LOCAL(fmpq, t);
    TRY(moments_between(t, j->context, &j->p->moments, j->from, j->to));
    TRY(snapshot_make(&s, j->context, j->p->envelope, t));
    for (size_t k = 0; k < j->count; k++)
        if (!done[k] && j->place[k].facet != SIZE_MAX && is_active(j, &j->place[k]))
            TRY(join_at_place(j, &s, k, done));
    return GRAZE_OK;
}

/* Find the moments at which joints of the cell may change: those at which its patches begin or end,
 * and for an edge also all moments of its events. */
static graze_status find_cuts(joining *j) {
    j->cuts.count = 0;
    for (size_t k = 0; k < j->count; k++) {
        TRY(cuts_add(&j->cuts, j->context, j->p->item[j->place[k].patch].from));
        TRY(cuts_add(&j->cuts, j->context, j->p->item[j->place[k].patch].to));
    }
    if (j->place->is_edge)
        TRY(cuts_add_of_edge(&j->cuts, j->context, &j->p->changes, &j->p->envelope->cells,
                             j->place->cell));
    numbers_sort(&j->cuts);
    return GRAZE_OK;
}

static graze_status join_cell(joining *j) {
    TRY(find_cuts(j));
    j->first_joint = j->p->joint_count;
    for (size_t k = 1; k < j->cuts.count; k++) {
        j->from = j->cuts.item[k - 1];
        j->to = j->cuts.item[k];
        TRY(join_all_of_cell(j));
        if (j->place->is_edge)
            TRY(join_within_edge(j));
    }
    return context_work(j->context, 1000);
}

static void joining_clear(joining *j) {
    numbers_clear(&j->cuts);
    numbers_clear(&j->set);
}

graze_status joints_find(graze_patches *p, graze_context *context) {
    ZEROED(joining, j);
    ZEROED(place_list, places);
    j.p = p;
    j.context = context;
    TRY(places_make(&places, context, p));
    for (size_t first = 0, end; first < places.count; first = end) {
        j.place = &places.item[first];
        for (end = first + 1; end < places.count && places.item[end].is_edge == j.place->is_edge &&
                              places.item[end].cell == j.place->cell;)
            end++;
        j.count = end - first;
        TRY(join_cell(&j));
    }
    return limits_find(p, context, &places);
}
