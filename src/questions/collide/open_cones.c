/* The sectors of each cone are cut by the planes of the other cone's sectors; each part is located
 * in the other cone. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * On the sphere, parts of the cones' arcs bound the intersection of both open sets, so one point of
 * each part is enough.
 */
#include "base/context/scope.h"
#include "questions/collide/features.h"

static int dot_sign(placing *p, const moving_vector *a, const moving_vector *b) {
    dot_moving(p->value, a, b);
    return placing_sign(p, p->value);
}

/* The sign of (a x b) . n: positive if b is to the left of a, seen against n. */
static int turn_about(placing *p, const moving_vector *a, const moving_vector *b,
                      const moving_vector *n) {
    HELD(moving_vector, cross);
    cross_moving(&cross, a, b);
    return dot_sign(p, &cross, n);
}

/* out = i a + j b with small integers; `out` may be a. */
static void combine_moving(moving_vector *out, slong i, const moving_vector *a, slong j,
                           const moving_vector *b) {
    LOCAL(fmpz_poly, term);
    for (int k = 0; k < 3; k++) {
        fmpz_poly_scalar_mul_si(term, &b->c[k], j);
        fmpz_poly_scalar_mul_si(&out->c[k], &a->c[k], i);
        fmpz_poly_add(&out->c[k], &out->c[k], term);
    }
}

/* Set the ray in which the arc from a to b crosses the plane with normal n; the signs of n . a and
 * n . b are opposite. */
static void ray_between(moving_vector *out, placing *p, const moving_vector *a,
                        const moving_vector *b, const moving_vector *n) {
    LOCAL(fmpz_poly, at_a);
    LOCAL(fmpz_poly, at_b);
    LOCAL(fmpz_poly, term);
    dot_moving(at_a, n, a);
    dot_moving(at_b, n, b);
    if (placing_sign(p, at_b) < 0)
        fmpz_poly_neg(at_b, at_b);
    else
        fmpz_poly_neg(at_a, at_a);
    for (int k = 0; k < 3; k++) {
        fmpz_poly_mul(&out->c[k], &a->c[k], at_b);
        fmpz_poly_mul(term, &b->c[k], at_a);
        fmpz_poly_add(&out->c[k], &out->c[k], term);
    }
}

void sectors_about_clear(sectors_about *list) {
    for (size_t k = 0; k < list->count; k++) {
        moving_vector_clear(&list->item[k].from);
        moving_vector_clear(&list->item[k].to);
        moving_vector_clear(&list->item[k].normal);
    }
    free(list->item);
    *list = (sectors_about){0};
}

static void add_sector(sectors_about *list, placing *p, const moving_vector *from,
                       const moving_vector *to) {
    if (!PLACING_ROOM(p, list, "the sectors of a cone"))
        return;
    sector *s = &list->item[list->count++];
    moving_vector_init(&s->from);
    moving_vector_init(&s->to);
    moving_vector_init(&s->normal);
    moving_set(&s->from, from);
    moving_set(&s->to, to);
    cross_moving(&s->normal, from, to);
}

/* Append a sector, with its orientation reversed if the motion mirrors or the solid is a
 * complement. */
static void add_oriented(sectors_about *list, placing *p, pair_side side, const moving_vector *from,
                         const moving_vector *to) {
    int turned = side == SIDE_MOVING ? placing_mirrors(p) : p->pair->complement;
    add_sector(list, p, turned ? to : from, turned ? from : to);
}

/* Append the half plane bounded by the line of `along`, on the side of `across`, as two sectors. */
static void add_half_plane(sectors_about *list, placing *p, pair_side side, moving_vector *along,
                           moving_vector *across) {
    add_oriented(list, p, side, along, across);
    moving_negate(along);
    add_oriented(list, p, side, across, along);
    moving_negate(along);
}

/* Append the half plane of all heights over a ray of E^2; the outer side of a segment is to its
 * right. */
static void add_upright(sectors_about *list, placing *p, pair_side side, moving_vector *ray,
                        int backward) {
    HELD(moving_vector, up);
    fmpz_poly_set_si(&up.c[2], backward ? -1 : 1);
    add_half_plane(list, p, side, &up, ray);
}

/* In E^2: append the rays from the point to those ends of a segment that are not the point. */
static void add_segment(sectors_about *list, placing *p, pair_side side, uint32_t simplex,
                        unsigned zero) {
    HELD(moving_vector, ray);
    edge_vector(&ray, p, side, simplex, 0, 1);
    if (!(zero & 2))
        add_upright(list, p, side, &ray, 1);
    moving_negate(&ray);
    if (!(zero & 1))
        add_upright(list, p, side, &ray, 0);
}

void sectors_about_add(sectors_about *list, placing *p, pair_side side, uint32_t simplex,
                       unsigned zero) {
    if (p->pair->motion->dimension == 2) {
        add_segment(list, p, side, simplex, zero);
        return;
    }
    HELD(moving_vector, along);
    HELD(moving_vector, across);
    /* The corner, or the first one of the side, that holds the point. */
    static const int first[8] = {0, 0, 1, 1, 2, 0, 2, 0};
    int k = first[zero & 7];
    edge_vector(&along, p, side, simplex, k, (k + 1) % 3);
    edge_vector(&across, p, side, simplex, k, (k + 2) % 3);
    if (zero & (zero - 1)) {
        add_oriented(list, p, side, &along, &across);
    } else {
        add_half_plane(list, p, side, &along, &across);
        if (!zero) {
            moving_negate(&along);
            moving_negate(&across);
            add_half_plane(list, p, side, &along, &across);
        }
    }
}

/* Is a direction in a sector's plane strictly inside the sector? */
static int is_in_sector(placing *p, const sector *s, const moving_vector *v) {
    return turn_about(p, &s->from, v, &s->normal) > 0 && turn_about(p, v, &s->to, &s->normal) > 0;
}

/* Does the arc between two directions cross a sector? 0: no; 1: once, in the sector's relative
 * interior; -1: the arc is in a special position. */
static int passes_sector(placing *p, const moving_vector *from, const moving_vector *to,
                         const sector *s) {
    int before = dot_sign(p, &s->normal, from), after = dot_sign(p, &s->normal, to);
    if (before == 0 && after == 0)
        return -1;
    if (before * after >= 0)
        return 0;
    HELD(moving_vector, at);
    ray_between(&at, p, from, to, &s->normal);
    int left = turn_about(p, &s->from, &at, &s->normal);
    int right = turn_about(p, &at, &s->to, &s->normal);
    return left > 0 && right > 0 ? 1 : left < 0 || right < 0 ? 0 : -1;
}

/* Locate a direction v by the arc from v to a direction in sector `last`: 1 if v is in the open
 * cone, 0 if not, -1 if the arc is in a special position. */
static int locate_by(placing *p, const sectors_about *cone, const moving_vector *v, size_t last,
                     const moving_vector *to) {
    int side = dot_sign(p, &cone->item[last].normal, v), inside = side < 0;
    for (size_t k = 0; k < cone->count && side && !p->status; k++) {
        int passes = k == last ? 0 : passes_sector(p, v, to, &cone->item[k]);
        side = passes < 0 ? 0 : side;
        inside ^= passes == 1;
    }
    return side ? inside : -1;
}

/* Is a direction that is in no sector in the open cone? Arcs to several directions of a sector are
 * tried. Only arcs in a plane through the direction and an end of another sector, or in that
 * sector's plane, are special: at most three for each sector. */
static int is_in_cone(placing *p, const sectors_about *cone, const moving_vector *v) {
    int found = -1;
    HELD(moving_vector, to);
    for (slong weight = 1; found < 0 && !p->status; weight++) {
        if ((size_t)weight > 3 * cone->count + 1)
            p->status = context_fail(p->context, GRAZE_EINTERNAL,
                                     "no arc tells if a direction at a common point is in a cone");
        for (size_t k = 0; k < cone->count && found < 0 && !p->status; k++) {
            combine_moving(&to, weight, &cone->item[k].from, 1, &cone->item[k].to);
            found = locate_by(p, cone, v, k, &to);
        }
    }
    return found > 0;
}

/* Rays inside a sector, in order from its first end to its last. */
typedef struct ray_list {
    size_t count, capacity;
    moving_vector *item;
} ray_list;

/* Insert a ray that is strictly inside the sector, unless the list has it. */
static void insert_ray(ray_list *list, placing *p, const sector *s, const moving_vector *ray) {
    size_t at = list->count;
    int turn = -1;
    while (at > 0 && (turn = turn_about(p, &list->item[at - 1], ray, &s->normal)) < 0)
        at--;
    if (at > 0 && turn == 0)
        return;
    if (!PLACING_ROOM(p, list, "the cuts of a sector"))
        return;
    for (size_t k = list->count; k > at; k--)
        list->item[k] = list->item[k - 1];
    moving_vector_init(&list->item[at]);
    moving_set(&list->item[at], ray);
    list->count++;
}

/* Cut a sector where it crosses another sector's plane or, if both planes are equal, at the other's
 * ends. */
static void cut_by(ray_list *list, placing *p, const sector *s, const sector *by) {
    int first = dot_sign(p, &by->normal, &s->from), last = dot_sign(p, &by->normal, &s->to);
    if (first == 0 && last == 0) {
        if (is_in_sector(p, s, &by->from))
            insert_ray(list, p, s, &by->from);
        if (is_in_sector(p, s, &by->to))
            insert_ray(list, p, s, &by->to);
    } else if (first * last < 0) {
        HELD(moving_vector, ray);
        ray_between(&ray, p, &s->from, &s->to, &by->normal);
        insert_ray(list, p, s, &ray);
    }
}

/* Is the part of a sector that has this ray inside it on the boundary of the common interior? */
static int part_meets(placing *p, const sector *s, const moving_vector *ray,
                      const sectors_about *other) {
    for (size_t k = 0; k < other->count && !p->status; k++)
        if (dot_sign(p, &other->item[k].normal, ray) == 0 && is_in_sector(p, &other->item[k], ray))
            return dot_sign(p, &s->normal, &other->item[k].normal) > 0;
    return is_in_cone(p, other, ray);
}

static int sector_meets(placing *p, const sector *s, const sectors_about *other) {
    ray_list cuts = {0};
    int found = 0;
    HELD(moving_vector, middle);
    for (size_t k = 0; k < other->count && !p->status; k++)
        cut_by(&cuts, p, s, &other->item[k]);
    for (size_t k = 0; k <= cuts.count && !found && !p->status; k++) {
        combine_moving(&middle, 1, k > 0 ? &cuts.item[k - 1] : &s->from, 1,
                       k < cuts.count ? &cuts.item[k] : &s->to);
        found = part_meets(p, s, &middle, other);
    }
    for (size_t k = 0; k < cuts.count; k++)
        moving_vector_clear(&cuts.item[k]);
    free(cuts.item);
    return found;
}

/* Do both cones have a sector in one plane, with opposite normals, and no sector beyond it? A cone
 * whose boundary is not beyond its sector's plane has nothing there, as it has nothing just there.
 */
static int plane_separates(placing *p, const sectors_about *a, const sectors_about *b) {
    for (size_t i = 0; i < a->count; i++) {
        const moving_vector *n = &a->item[i].normal;
        int flat = 0, apart = 1;
        for (size_t k = 0; k < a->count + b->count && apart && !p->status; k++) {
            const sector *s = k < a->count ? &a->item[k] : &b->item[k - a->count];
            int from = dot_sign(p, n, &s->from), to = dot_sign(p, n, &s->to);
            apart = k < a->count ? from <= 0 && to <= 0 : from >= 0 && to >= 0;
            flat |= apart && k >= a->count && !from && !to && dot_sign(p, n, &s->normal) < 0;
        }
        if (apart && flat)
            return 1;
    }
    return 0;
}

int open_cones_meet(placing *p, const sectors_about *a, const sectors_about *b) {
    int found = 0;
    if (plane_separates(p, a, b))
        return 0;
    for (size_t k = 0; k < a->count && !found && !p->status; k++)
        found = sector_meets(p, &a->item[k], b);
    for (size_t k = 0; k < b->count && !found && !p->status; k++)
        found = sector_meets(p, &b->item[k], a);
    return found;
}
