/* Roles by the signs of g; at saddles and pinches by the directions that the germs leave open, with
 * the planes of the simplices next to the point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/contact/nearby.h"

#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "questions/topo/topo.h"

/* The simplices whose boxes meet a box, and the smallest extent of these boxes. */
typedef struct neighbours {
    graze_context *context;
    const graze_solid *solid;
    box around;
    uint32_t *item;
    size_t count, capacity;
    double extent;
} neighbours;

static void neighbours_clear(neighbours *n) {
    free(n->item);
}

static graze_status search_around(neighbours *n, size_t index) {
    const tree_node *node = &n->solid->boxes.node[index];
    if (!box_meets(&node->box, &n->around))
        return GRAZE_OK;
    if (node->child) {
        TRY(search_around(n, node->child));
        return search_around(n, node->child + 1);
    }
    n->extent = fmin(n->extent, box_extent(&node->box));
    TRY(LIST_GROW(n->context, n, "the facets around a point"));
    n->item[n->count++] = node->simplex;
    return GRAZE_OK;
}

/* Search with the box of half width `half` around the point, rounded outward. */
static graze_status search_box(neighbours *n, const fmpq *point, const fmpq_t half) {
    double unused;
    LOCAL(fmpq, side);
    for (int i = 0; i < n->solid->input.dimension; i++) {
        fmpq_sub(side, point + i, half);
        rational_bounds(&n->around.low[i], &unused, side);
        fmpq_add(side, point + i, half);
        rational_bounds(&unused, &n->around.high[i], side);
    }
    n->count = 0;
    return search_around(n, 0);
}

/* Choose the half width of the box: at most a quarter of the smallest extent found, so that few
 * simplices meet the box. Any number above 0 would be right. */
static void choose_half(fmpq_t half, double extent) {
    int exponent = 0;
    if (extent > 0 && extent < INFINITY)
        frexp(extent, &exponent);
    fmpq_one(half);
    rational_shift(half, exponent - 3);
}

/* Append the planes of the box's sides to the list, which has room for them. */
static void set_box_sides(plane_list *list, const fmpq *point, const fmpq_t half) {
    size_t d = (size_t)list->dimension, first = list->count;
    LOCAL(fmpq, at);
    for (size_t k = 0; k < 2 * d; k++) {
        fmpz *form = list->form + (first + k) * (d + 1);
        (k % 2 ? fmpq_add : fmpq_sub)(at, point + k / 2, half);
        fmpz_set(form + k / 2, fmpq_denref(at));
        fmpz_neg(form + d, fmpq_numref(at));
        list->start[first + k + 1] = list->start[first];
    }
    list->count += 2 * d;
}

/* Make room for 2d more planes; 0 when out of memory. */
static int widen_planes(plane_list *list) {
    size_t d = (size_t)list->dimension, more = 2 * d, used = list->count * (d + 1);
    uint32_t *start = realloc(list->start, (list->count + more + 1) * sizeof *start);
    if (!start)
        return 0;
    list->start = start;
    fmpz *form = _fmpz_vec_init((slong)(used + more * (d + 1)));
    _fmpz_vec_swap(form, list->form, (slong)used);
    _fmpz_vec_clear(list->form, (slong)used);
    list->form = form;
    return 1;
}

static graze_status list_planes(plane_list *out, const neighbours *n) {
    if (planes_find(out, NULL, n->solid, n->item, n->count) == 0) {
        for (size_t k = 0; k < n->count; k++)
            out->order[k] = n->item[out->order[k]];
        if (widen_planes(out))
            return GRAZE_OK;
        planes_clear(out);
    }
    return context_fail(n->context, GRAZE_ESYSTEM, "out of memory for the planes around a point");
}

/* List the planes of the simplices whose boxes meet a box around a point of d rationals, then the
 * planes of the box's sides, in which no simplex is listed. A ray from the point stays in the box
 * until it meets one of the latter, and in the box the boundary has no other simplices: so a cone
 * made of this list equals the cone made of all planes, and the time for it does not grow with the
 * solid. planes_clear after GRAZE_OK. */
static graze_status around_planes(plane_list *out, graze_context *context, const graze_solid *solid,
                                  const fmpq *point) {
    ZEROED(neighbours, n);
    LOCAL(fmpq, half);
    n.context = context;
    n.solid = solid;
    n.extent = INFINITY;
    TRY(search_box(&n, point, half));
    choose_half(half, n.extent);
    TRY(search_box(&n, point, half));
    TRY(list_planes(out, &n));
    set_box_sides(out, point, half);
    return GRAZE_OK;
}

/* The signs of g on one side of t. */
typedef struct g_signs {
    int any, all_positive, all_negative, some_positive, some_negative;
} g_signs;

static g_signs signs_on(const graze_site *s, int side) {
    g_signs out = {0, 1, 1, 0, 0};
    for (size_t k = 0; k < s->germ_count; k++) {
        if (s->germ[k].side != side)
            continue;
        int sign = fmpq_sgn(s->germ[k].speed);
        out.any = 1;
        out.all_positive &= sign > 0;
        out.all_negative &= sign < 0;
        out.some_positive |= sign > 0;
        out.some_negative |= sign < 0;
    }
    return out;
}

/* Is a direction of the body in the germ's cone, or in its sweep along a leading direction? */
static graze_status is_in_germ(int *out, graze_context *context, germ *g, const fmpz *u) {
    graze_state state = GRAZE_STATE_O;
    TRY(cone_state(&state, &g->cone, context, u));
    *out = state != GRAZE_STATE_O;
    for (int k = 0; k < g->side_count && !*out; k++) {
        int in_interior;
        TRY(cone_sweep(&in_interior, out, &g->cone, context, NULL, u, g->side[k].e));
    }
    return GRAZE_OK;
}

/* *out = 1 if the direction u, in the body's space, is in none of the germs (is_in_germ). */
static graze_status is_in_none(int *out, graze_context *context, germ_list *germs, const fmpz *u) {
    int covered = 0;
    for (size_t j = 0; j < germs->count && !covered; j++)
        TRY(is_in_germ(&covered, context, &germs->item[j], u));
    *out = !covered;
    return GRAZE_OK;
}

/* Does a leading direction point into the interior? Then all directions are covered. */
static graze_status leads_inside(int *out, graze_context *context, germ_list *germs) {
    *out = 0;
    for (size_t j = 0; j < germs->count; j++)
        for (int k = 0; k < germs->item[j].side_count && !*out; k++) {
            graze_state state = GRAZE_STATE_O;
            TRY(cone_state(&state, &germs->item[j].cone, context, germs->item[j].side[k].e));
            *out = state == GRAZE_STATE_I;
        }
    return GRAZE_OK;
}

/* Look for an uncovered direction among the outward normals and their sum: often there is one, and
 * no arrangement is needed. */
static graze_status try_normals(int *found, graze_context *context, germ_list *germs,
                                const neighborhood *p) {
    int d = p->dimension;
    LOCAL_VEC(fmpz, sum, d);
    for (size_t k = 0; k < p->count && !*found; k++) {
        _fmpz_vec_add(sum, sum, p->facet[k].normal, d);
        TRY(is_in_none(found, context, germs, p->facet[k].normal));
    }
    if (!*found)
        TRY(is_in_none(found, context, germs, sum));
    return GRAZE_OK;
}

/* Is a direction in a cell of full dimension around ray r covered by none of the germs? All germs,
 * which are of one time, carry a direction to the body alike. */
static graze_status look_for_open(int *found, graze_context *context, germ_list *germs,
                                  const borders *b, size_t r) {
    HELD(ray_cells, cells, b, r);
    LOCAL_VEC(fmpz, u, b->dimension);
    for (size_t k = 0; k < cells.count && !*found; k += b->dimension == 2 ? 1 : 2) {
        germ_to_body(u, &germs->item[0], cells.item + k * (size_t)b->dimension);
        TRY(is_in_none(found, context, germs, u));
    }
    return GRAZE_OK;
}

static graze_status look_everywhere(int *found, graze_context *context, germ_list *germs) {
    int refused = 0;
    HELD(borders, b, germs->item[0].cone.dimension);
    TRY(borders_find(&b, &refused, context, germs));
    if (refused)
        return context_fail(context, GRAZE_ELIMIT,
                            "more planes border what is covered about the point than the %d that "
                            "are looked at",
                            BORDER_PLANES);
    for (size_t r = 0; r < b.ray_count && !*found; r++)
        TRY(look_for_open(found, context, germs, &b, r));
    return GRAZE_OK;
}

/* Do the germs beside t leave a direction open? */
static graze_status look_at_germs(int *out, graze_context *context, const graze_site *s,
                                  const plane_list *planes) {
    int inside = 0;
    HELD(germ_list, germs);
    for (int k = sides_within_piece(s->side); k < 2; k++)
        if (s->side[k].present)
            TRY(germs_at(&germs, context, s->scene, planes, s->world, s->side[k].piece,
                         s->side[k].u));
    TRY(leads_inside(&inside, context, &germs));
    if (!inside)
        TRY(try_normals(out, context, &germs, &s->place));
    return inside || *out ? GRAZE_OK : look_everywhere(out, context, &germs);
}

static graze_status is_open_at(int *out, graze_context *context, const graze_site *s) {
    plane_list planes;
    *out = 0;
    TRY(around_planes(&planes, context, s->scene->solid, s->y));
    graze_status status = look_at_germs(out, context, s, &planes);
    planes_clear(&planes);
    return status;
}

graze_status role_decide(graze_role *out, graze_context *context, const graze_site *s) {
    g_signs before = signs_on(s, -1), after = signs_on(s, 1);
    int contact = 0;
    if (s->place.kind == PLACE_OTHER)
        TRY(is_open_at(&contact, context, s));
    else if (s->place.kind == PLACE_REFLEX)
        contact = !(after.any && after.some_positive) && !(before.any && before.some_negative);
    else
        contact = !(after.any && after.all_positive) && !(before.any && before.all_negative);
    *out = contact                                     ? GRAZE_ROLE_CONTACT
           : before.all_positive && after.all_positive ? GRAZE_ROLE_EGRESS
           : before.all_negative && after.all_negative ? GRAZE_ROLE_INGRESS
                                                       : GRAZE_ROLE_HIDDEN;
    return GRAZE_OK;
}

NAMES_OF(graze_role_name, graze_role,
         {[GRAZE_ROLE_CONTACT] = "contact",
          [GRAZE_ROLE_EGRESS] = "egress",
          [GRAZE_ROLE_INGRESS] = "ingress",
          [GRAZE_ROLE_HIDDEN] = "hidden"})

NAMES_OF(graze_trim_name, graze_trim,
         {[GRAZE_TRIM_SLIDES] = "slides",
          [GRAZE_TRIM_SIMPLE] = "simple",
          [GRAZE_TRIM_MEETS] = "meets",
          [GRAZE_TRIM_NEAR] = "trimmed_near",
          [GRAZE_TRIM_FAR] = "trimmed_far"})

NAMES_OF(graze_orientation_name, graze_orientation,
         {[GRAZE_ORIENTATION_PRESERVING] = "preserving",
          [GRAZE_ORIENTATION_REVERSING] = "reversing",
          [GRAZE_ORIENTATION_DEGENERATE] = "degenerate"})
