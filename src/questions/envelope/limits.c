/* Places where patches end, and their limits.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A patch ends on an edge u v at u + lambda (v - u), lambda = g_u / (g_u - g_v). At a moment lambda
 * tends to 0 if the zero of g_u has a higher order than that of g_v, to 1 if it has a lower one. If
 * both have order k, lambda tends to the same expression with the derivatives of order k in place
 * of g_u and g_v.
 */
#include "base/context/scope.h"
#include "questions/envelope/patch_ends.h"

static graze_status add_patch_place(place_list *list, graze_context *context, int is_edge,
                                    size_t cell, size_t facet, size_t patch) {
    TRY(LIST_GROW(context, list, "the ends of patches"));
    list->item[list->count++] = (patch_place){is_edge, cell, facet, patch};
    return GRAZE_OK;
}

static graze_status add_end(place_list *list, graze_context *context, const part_end *end,
                            size_t patch) {
    return end->vertex != SIZE_MAX
               ? add_patch_place(list, context, 0, end->vertex, SIZE_MAX, patch)
               : add_patch_place(list, context, 1, end->edge, end->facet, patch);
}

/* Add the places of a whole facet: all its edges; in E^2 the vertices of its edges. */
static graze_status add_border_places(place_list *list, graze_context *context,
                                      const cell_complex *c, size_t facet, size_t patch) {
    for (size_t j = c->facet_edges.start[facet]; j < c->facet_edges.start[facet + 1]; j++) {
        size_t edge = c->facet_edges.item[j];
        if (c->dimension == 3) {
            TRY(add_patch_place(list, context, 1, edge, SIZE_MAX, patch));
            continue;
        }
        TRY(add_patch_place(list, context, 0, c->edge[edge].u, SIZE_MAX, patch));
        TRY(add_patch_place(list, context, 0, c->edge[edge].v, SIZE_MAX, patch));
    }
    return GRAZE_OK;
}

/* Add the places of a patch. A run between both ends of its edge has, besides its ends, all of the
 * edge as a place. */
static graze_status add_patch_places(place_list *list, graze_context *context,
                                     const cell_complex *c, const patch *item, size_t patch) {
    const part_end *a = &item->end[0], *b = &item->end[1];
    if (item->facts.kind == GRAZE_CURVE_WHOLE)
        return add_border_places(list, context, c, item->number, patch);
    TRY(add_end(list, context, a, patch));
    TRY(add_end(list, context, b, patch));
    if (item->facts.kind == GRAZE_CURVE_RUN && a->vertex != SIZE_MAX && b->vertex != SIZE_MAX)
        TRY(add_patch_place(list, context, 1, item->number, SIZE_MAX, patch));
    return GRAZE_OK;
}

static int compare_patch_places(const void *left, const void *right) {
    const patch_place *a = left, *b = right;
    int order = a->is_edge - b->is_edge;
    order = order ? order : array_compare_numbers(&a->cell, &b->cell);
    order = order ? order : array_compare_numbers(&a->patch, &b->patch);
    return order ? order : array_compare_numbers(&a->facet, &b->facet);
}

graze_status places_make(place_list *out, graze_context *context, const graze_patches *p) {
    for (size_t k = 0; k < p->count; k++)
        TRY(add_patch_places(out, context, &p->envelope->cells, &p->item[k], k));
    out->count = array_sort_once(out->item, out->count, sizeof *out->item, compare_patch_places);
    return GRAZE_OK;
}

void place_list_clear(place_list *list) {
    free(list->item);
}

size_t places_first(const place_list *list, int is_edge, size_t cell) {
    const patch_place key = {is_edge, cell, 0, 0};
    return array_first(&key, list->item, list->count, sizeof key, compare_patch_places);
}

graze_status members_add(numbers *set, graze_context *context, size_t patch) {
    return numbers_add(set, context, patch, "the patches of a joint");
}

graze_status joint_add(graze_patches *p, graze_context *context, const graze_cell *cell,
                       graze_chain_form form, size_t from, size_t to, const numbers *set) {
    TRY(ARRAY_GROW(context, p->joint, p->joint_capacity, p->joint_count + 1,
                   "the joints of patches"));
    TRY(ARRAY_GROW(context, p->member, p->member_capacity, p->member_count + set->count,
                   "the joints of patches"));
    p->joint[p->joint_count++] = (patch_joint){*cell, form, from, to, p->member_count, set->count};
    for (size_t k = 0; k < set->count; k++)
        p->member[p->member_count++] = set->item[k];
    return GRAZE_OK;
}

/* A place where a patch ends at a moment, which is the parameter `u` of the motion's piece `piece`;
 * on an edge, g has zeros of order `order` at both ends of the edge. */
typedef struct limit_place {
    int is_edge;
    size_t cell, facet, patch, piece;
    algebraic *u;
    slong order;
} limit_place;

typedef struct limit_finder {
    graze_patches *p;
    graze_context *context;
    const place_list *places;
    size_t moment, piece; /* the piece after the moment */
    int is_break;
    algebraic before, after; /* parameters of the moment in the pieces before and after */
    size_t count, capacity;
    limit_place *item;
    numbers set;
} limit_finder;

/* g of a facet at one end of an edge, differentiated `order` times. */
static void derived_g(fmpz_poly_t out, const limit_finder *f, const limit_place *at, int at_v) {
    const cell_edge *edge = &f->p->envelope->cells.edge[at->cell];
    derivatives_velocity(out, &f->p->envelope->field[at->piece], at->facet,
                         at_v ? edge->v : edge->u);
    for (slong k = 0; k < at->order; k++)
        fmpz_poly_derivative(out, out);
}

/* The order of the zero that g at one end of the edge has at the moment: 0 if g is not 0. */
static graze_status zero_order(slong *out, const limit_finder *f, const limit_place *at, int at_v) {
    int sign = 0;
    LOCAL(fmpz_poly, g);
    derived_g(g, f, at, at_v);
    for (*out = 0; !fmpz_poly_is_zero(g); ++*out) {
        TRY(algebraic_sign_at(&sign, f->context, g, at->u));
        if (sign)
            break;
        fmpz_poly_derivative(g, g);
    }
    return GRAZE_OK;
}

/* Replace a place on an edge by an end of the edge if the place tends to that end at the moment. */
static graze_status take_limit(const limit_finder *f, limit_place *at) {
    const cell_edge *edge = &f->p->envelope->cells.edge[at->cell];
    slong at_u = 0, at_v = 0;
    TRY(zero_order(&at_u, f, at, 0));
    TRY(zero_order(&at_v, f, at, 1));
    at->order = at_u;
    if (at_u != at_v) {
        at->is_edge = 0;
        at->cell = at_u > at_v ? edge->u : edge->v;
    }
    return GRAZE_OK;
}

/* Set the place to which an end of a patch tends at the moment. If the moment is a break and the
 * patch ends at it, the piece before the break is used, else the piece after. */
static graze_status place_at_moment(limit_place *out, limit_finder *f, const patch_place *place) {
    int earlier = f->is_break && f->p->item[place->patch].to == f->moment;
    *out = (limit_place){
        place->is_edge, place->cell, place->facet, place->patch, f->piece, &f->after, 0};
    if (earlier) {
        out->piece = f->piece - 1;
        out->u = &f->before;
    }
    return place->is_edge ? take_limit(f, out) : GRAZE_OK;
}

/* *out becomes the sign of a_u b_v - a_v b_u for two places a and b on one edge: 0 if they
 * coincide. */
static graze_status compare_within(int *out, limit_finder *f, const limit_place *a,
                                   const limit_place *b) {
    LOCAL_VEC(fmpz_poly, at, 4); /* 0 a_u, 1 a_v, 2 b_v, 3 b_u */
    LOCAL_VEC(fmpq, value, 4);
    for (int k = 0; k < 4; k++)
        derived_g(at + k, f, k < 2 ? a : b, k == 1 || k == 2);
    if (a->piece == b->piece) {
        cross_terms(at, at, at + 1, at + 3, at + 2);
        return algebraic_sign_at(out, f->context, at, a->u);
    }
    for (int k = 0; k < 4; k++) /* at a break, where the parameters are 1 (before) and 0 (after) */
        fmpz_poly_evaluate_fmpq(value + k, at + k, k < 2 ? a->u->value : b->u->value);
    fmpq_mul(value, value, value + 2);
    fmpq_mul(value + 1, value + 1, value + 3);
    *out = fmpq_cmp(value, value + 1);
    return GRAZE_OK;
}

static graze_status is_same_place(int *out, limit_finder *f, const limit_place *a,
                                  const limit_place *b) {
    int order = 0;
    *out = a->is_edge == b->is_edge && a->cell == b->cell;
    if (!*out || !a->is_edge || (a->facet == b->facet && a->piece == b->piece))
        return GRAZE_OK;
    TRY(compare_within(&order, f, a, b));
    *out = order == 0;
    return GRAZE_OK;
}

/* Add to the set each patch that exists before and after the moment and, at the moment, has an end
 * at the place `at`. */
static graze_status add_passing(limit_finder *f, const limit_place *at) {
    for (size_t k = places_first(f->places, at->is_edge, at->cell); k < f->places->count; k++) {
        const patch_place *place = &f->places->item[k];
        const patch *item = &f->p->item[place->patch];
        limit_place there;
        int same = 0;
        if (place->is_edge != at->is_edge || place->cell != at->cell)
            break;
        if (item->from >= f->moment || item->to <= f->moment ||
            (place->is_edge && place->facet == SIZE_MAX))
            continue;
        TRY(place_at_moment(&there, f, place));
        TRY(is_same_place(&same, f, at, &there));
        if (same)
            TRY(members_add(&f->set, f->context, place->patch));
    }
    return GRAZE_OK;
}

/* Add the joint at the place of entry `first`, if two or more patches meet there. Entries at that
 * place get the piece SIZE_MAX, a mark that they are done. */
static graze_status join_limits(limit_finder *f, size_t first) {
    const cell_complex *c = &f->p->envelope->cells;
    limit_place at = f->item[first];
    f->set.count = 0;
    for (size_t k = first; k < f->count; k++) {
        int same = 0;
        if (f->item[k].piece == SIZE_MAX)
            continue;
        TRY(is_same_place(&same, f, &at, &f->item[k]));
        if (!same)
            continue;
        f->item[k].piece = SIZE_MAX;
        TRY(members_add(&f->set, f->context, f->item[k].patch));
    }
    TRY(add_passing(f, &at));
    numbers_sort(&f->set);
    if (f->set.count < 2)
        return GRAZE_OK;
    return joint_add(f->p, f->context,
                     at.is_edge ? &c->edge[at.cell].name : &c->vertex[at.cell].name,
                     GRAZE_CHAIN_NONE, f->moment, f->moment, &f->set);
}

/* A place where a patch ends, with the moment at which the patch begins or ends. */
typedef struct dated_place {
    size_t moment, place;
} dated_place;

static int compare_dates(const void *left, const void *right) {
    const dated_place *a = left, *b = right;
    int order = array_compare_numbers(&a->moment, &b->moment);
    return order ? order : array_compare_numbers(&a->place, &b->place);
}

static void begin_moment(limit_finder *f, size_t moment) {
    const graze_time *time = f->p->moments.time[moment];
    f->moment = moment;
    f->piece = time->piece;
    algebraic_set(&f->after, &time->u);
    f->is_break = algebraic_is_rational(&time->u) && fmpq_is_zero(time->u.value) &&
                  f->p->envelope->is_break[time->piece];
    f->count = 0;
}

/* Add the joints of one moment; the list has the places of all patches that begin or end at it. */
static graze_status join_moment(limit_finder *f, const dated_place *list, size_t count) {
    begin_moment(f, list->moment);
    for (size_t k = 0; k < count; k++) {
        const patch_place *place = &f->places->item[list[k].place];
        if (place->is_edge && place->facet == SIZE_MAX)
            continue;
        TRY(LIST_GROW(f->context, f, "the joints of patches"));
        TRY(place_at_moment(&f->item[f->count++], f, place));
    }
    for (size_t k = 0; k < f->count; k++)
        if (f->item[k].piece != SIZE_MAX)
            TRY(join_limits(f, k));
    return context_work(f->context, 1000);
}

/* List all places with the moments at which their patches begin and end, except the ends of the
 * motion; return the number of entries. */
static size_t date_places(dated_place *out, const graze_patches *p, const place_list *places) {
    size_t count = 0;
    for (size_t k = 0; k < places->count; k++) {
        const patch *item = &p->item[places->item[k].patch];
        if (item->from > 0)
            out[count++] = (dated_place){item->from, k};
        if (item->to + 1 < p->moments.count)
            out[count++] = (dated_place){item->to, k};
    }
    qsort(out, count, sizeof *out, compare_dates);
    return count;
}

static void limit_finder_init(limit_finder *f, graze_patches *p, graze_context *context,
                              const place_list *places) {
    *f = (limit_finder){.p = p, .context = context, .places = places};
    algebraic_init(&f->before);
    algebraic_init(&f->after);
    fmpq_one(f->before.value);
}

static void limit_finder_clear(limit_finder *f) {
    algebraic_clear(&f->before);
    algebraic_clear(&f->after);
    free(f->item);
    numbers_clear(&f->set);
}

graze_status limits_find(graze_patches *p, graze_context *context, const place_list *places) {
    HELD(limit_finder, f, p, context, places);
    FREED(dated_place, dated, malloc((2 * places->count + 1) * sizeof *dated));
    if (!dated)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for the joints of patches");
    size_t count = date_places(dated, p, places);
    for (size_t first = 0, next; first < count; first = next) {
        for (next = first + 1; next < count && dated[next].moment == dated[first].moment;)
            next++;
        TRY(join_moment(&f, dated + first, next - first));
    }
    return GRAZE_OK;
}
