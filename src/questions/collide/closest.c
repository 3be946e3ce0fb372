/* The least distance of two solids: a bisection whose questions are whether a distance is reached.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Invariant: the distance is always above `low`, and at most `high` at a rational time. The
 * tolerance ends the questions, and changes none: enclosures are nested.
 */
#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "questions/collide/near_pairs.h"

enum { MOST_QUESTIONS = 200 };

/** A pair whose clearance is asked for, and the time of `high`. */
typedef struct approach {
    graze_pair asked;
    graze_context *context;
    size_t piece;
    fmpq_t u;
} approach;

static void approach_clear(approach *a) {
    collide_clear(&a->asked);
    fmpq_clear(a->u);
}

/* Find out whether a distance is reached. */
static graze_status ask_distance(int *reached, approach *a, double distance) {
    graze_pair *asked = &a->asked;
    pair_walk *walk = &asked->walk;
    TRY(rational_from_double(asked->distance, a->context, distance));
    int none = distance == 0 && !asked->pair.round[0] && !asked->pair.round[1];
    asked->pair.near = none ? NULL : asked->clearance;
    pair_walk_clear(walk);
    walk->first = 1;
    TRY(collide_walk(asked, a->context));
    *reached = strcmp(walk->word, "O") != 0;
    return GRAZE_OK;
}

/* Keep a rational time at which the distance is at most the one that is reached; 0 if no such time
 * is known, where it is reached at an irrational instant alone. */
static int keep_reached(approach *a) {
    const pair_walk *walk = &a->asked.walk;
    const graze_time *from = walk->contact_count ? walk->contact[0].from : NULL;
    int irrational = from && !algebraic_is_rational(&from->u);
    if (irrational && walk->gap != GRAZE_STATE_I && walk->gap != GRAZE_STATE_B)
        return 0;
    a->piece = irrational ? walk->looked_piece : from ? from->piece : 0;
    fmpq_zero(a->u);
    if (from)
        fmpq_set(a->u, irrational ? walk->looked : from->u.value);
    return 1;
}

/* The longest side of the box around both bases, and the greatest diameter. */
static double size_of(const solid_pair *pair, int side) {
    const graze_solid *solid = side ? pair->fixed : pair->moving;
    double low, high = 0, most = 0;
    for (size_t k = 0; pair->round[side] && k < solid->cut.count; k++) {
        rational_bounds(&low, &high, pair->round[side][k].radius);
        most = fmax(most, high);
    }
    return box_extent(&solid->boxes.node[0].box) + 2 * most;
}

/* The next distance to ask for; not between the bounds if no double is. */
static double next_distance(const graze_closest *c, double size) {
    return c->high < INFINITY ? c->low + (c->high - c->low) / 2 : c->low > 0 ? 2 * c->low : size;
}

static graze_status narrow_distance(graze_closest *c, approach *a, double size, double tolerance) {
    for (int k = 0; k < MOST_QUESTIONS && !(c->high - c->low + 0x1p-50 * c->high <= tolerance);
         k++) {
        double distance = next_distance(c, size);
        int reached = 1;
        if (!(c->low < distance && distance < c->high))
            break;
        TRY(ask_distance(&reached, a, distance));
        if (reached && !keep_reached(a)) { /* a little further it is reached for a while */
            distance = nextafter(distance, (double)INFINITY);
            if (distance < c->high)
                TRY(ask_distance(&reached, a, distance));
            if (!keep_reached(a))
                break;
        }
        *(reached ? &c->high : &c->low) = distance;
    }
    return GRAZE_OK;
}

/* Carry a point of the fixed solid's space to the world's. */
static void carry_to_world(fmpq *point, const graze_motion *motion, const approach *a) {
    const graze_motion *frame = a->asked.frame;
    size_t k = 0;
    LOCAL_VEC(fmpq, map, POINT_MAP_ENTRIES);
    LOCAL_VEC(fmpq, image, 3);
    LOCAL(fmpq, t);
    if (!frame)
        return;
    motion_time_at(t, &motion->piece[a->piece], a->u);
    while (fmpq_cmp(t, frame->piece[k].hi) > 0)
        k++;
    motion_parameter_at(t, &frame->piece[k], t);
    point_map_at(map, &frame->piece[k].forward, t);
    affine_image(image, map, point, motion->dimension);
    for (int i = 0; i < 3; i++)
        fmpq_swap(point + i, image + i);
}

/* Set the places from the stationary points of two faces, moved towards one another by the radii.
 */
static void set_near_places(graze_closest *c, placing *p, const approach *a,
                            const feature_pair *found) {
    int d = p->pair->motion->dimension;
    double share[2] = {0, 0}, distance = 0;
    LOCAL(fmpq, part);
    LOCAL_VEC(fmpq, point, 6);
    HELD(stationary, s, p, found);
    stationary_points(point, p, &s);
    for (int i = 0; i < d; i++) {
        fmpq_sub(part, point + i, point + 3 + i);
        distance = hypot(distance, fmpq_get_d(part));
    }
    for (int side = 0; side < 2; side++) {
        const csg_round *round = p->pair->round[side];
        const length_ratio *ratio = &p->near->ratio[1 + side];
        fmpq_set_fmpz_frac(part, ratio->square[0].coeffs, ratio->square[1].coeffs);
        if (round)
            share[side] = fmpq_get_d(round[found->of[side].simplex].radius) *
                          sqrt(fmpq_get_d(part)) / distance;
        carry_to_world(point + (ptrdiff_t)3 * side, p->pair->motion, a);
    }
    for (int i = 0; i < d; i++) {
        double x[2] = {fmpq_get_d(point + i), fmpq_get_d(point + 3 + i)};
        for (int side = 0; side < 2; side++)
            c->at[3 * side + i] = x[side] + share[side] * (x[!side] - x[side]);
    }
    c->placed = 1;
}

/* Find two faces that are at most `high` apart at the time of `high`, and their places. */
static graze_status find_near_places(graze_closest *c, approach *a) {
    ZEROED(feature_list, list);
    TRY(rational_from_double(a->asked.distance, a->context, c->high));
    HELD(placing, p, a->context, &a->asked.pair, a->piece, a->u);
    TRY(features_near(&list, &p));
    if (list.count)
        set_near_places(c, &p, a, list.item);
    return p.status;
}

/* Set the time of `high`. */
static graze_status set_time(graze_pair *pair, const approach *a, const algebraic *u) {
    TRY(time_make(&pair->closest_time, a->context, pair->pair.motion, a->piece, u));
    pair->closest.time = pair->closest_time;
    return time_canonicalise(pair->closest_time, a->context);
}

graze_status collide_closest(graze_pair *pair, graze_context *context) {
    graze_closest *c = &pair->closest;
    int reached;
    ZEROED(approach, a);
    HELD(algebraic, u);
    a.context = context;
    a.asked.pair = pair->pair;
    a.asked.pair.near = NULL;
    a.asked.frame = pair->frame;
    fmpq_one(a.asked.distance);
    TRY(collide_set_clearance(&a.asked, context));
    double size = size_of(&pair->pair, 0) + size_of(&pair->pair, 1);
    double tolerance = pair->options.closest * (pair->options.closest_relative ? size : 1);
    TRY(ask_distance(&reached, &a, 0));
    if (reached) {
        const pair_walk *walk = &a.asked.walk;
        if (walk->contact_count)
            algebraic_set(&u, &walk->contact[0].from->u);
        a.piece = walk->contact_count ? walk->contact[0].from->piece : 0;
        return set_time(pair, &a, &u);
    }
    c->high = INFINITY;
    TRY(narrow_distance(c, &a, size, tolerance));
    if (!(c->high < INFINITY))
        return context_fail(context, GRAZE_ELIMIT, "the least distance is beyond doubles");
    c->wide = !(c->high - c->low <= tolerance);
    fmpq_set(u.value, a.u);
    TRY(set_time(pair, &a, &u));
    return find_near_places(c, &a);
}
