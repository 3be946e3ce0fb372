/* The time at which all motions near a given one have met at the latest (proofs/collision.md C147).
 * Each time at which a point is deep enough is such a bound. The points do not depend on the error,
 * so that enclosures are nested. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "questions/collide/near_pairs.h"

/* The most cells of a solid, evenly chosen, that give points; halvings of an irrational time, and
 * places of a root; the most facets of a convex solid whose depths are found for all points. */
enum { MOST_ASKED = 64, HALVINGS = 40, MOST_FACETS = 512 };

typedef graze_pair collide; /* as a local that collide_clear clears */

/* Replace *best by the time at which a pair enters a state at a distance, if that is earlier. */
static graze_status ask_entry(graze_time **best, graze_context *context, const graze_pair *of,
                              const solid_pair *pair, const fmpq_t distance, graze_state until) {
    graze_motion part = *pair->motion;
    size_t piece = of->begun ? of->begun->piece : 0;
    int order = -1;
    HELD(algebraic, start);
    ZEROED(collide, p);
    part.piece += piece;
    part.piece_count = (of->high ? of->high->piece + 1 : part.piece_count) - piece;
    p.pair = *pair;
    p.pair.motion = &part;
    p.frame = of->frame;
    p.walk.first = 1;
    p.walk.until = until;
    p.walk.limit = of->high ? &of->high->u : NULL;
    fmpq_set(p.distance, distance);
    TRY(collide_set_clearance(&p, context));
    TRY(collide_walk(&p, context));
    if (p.walk.gap != until)
        return GRAZE_OK;
    algebraic *u = p.walk.last ? &p.walk.last->u : &start;
    piece += p.walk.last ? p.walk.last->piece : 0;
    if (*best && piece == (*best)->piece)
        TRY(algebraic_compare(&order, context, u, &(*best)->u));
    if (order >= 0)
        return GRAZE_OK;
    time_destroy(*best);
    return time_make(best, context, pair->motion, piece, u);
}

/* Ask when a point, if it is in its solid, is deeper in the other one than the error less the
 * clearance and, in a ball or capsule, less the least radius. */
static graze_status ask_depth(graze_pair *pair, graze_context *context, int side, const fmpz *x) {
    int d = pair->pair.motion->dimension;
    LOCAL_VEC(fmpq, at, 4);
    csg_round point = {.ends = 1, .end = at, .radius = {{0, 1}}};
    csg curved = {.dimension = d, .round_count = 1, .round = &point};
    const graze_solid solid = {.input.dimension = d, .curved = &curved};
    solid_pair asked = pair->pair;
    const graze_solid **own = side ? &asked.fixed : &asked.moving;
    if (asked.round[side])
        clearance_least(at + 3, pair);
    else if (solid_locate(*own, x) != GRAZE_STATE_O)
        fmpq_set(at + 3, pair->distance);
    else
        return GRAZE_OK;
    *own = &solid;
    asked.round[side] = NULL;
    asked.complement = side ? 2 : 1;
    for (int i = 0; i < d; i++)
        fmpq_set_fmpz_frac(at + i, x + i, x + d);
    fmpq_sub(at + 3, pair->error, at + 3);
    return ask_entry(&pair->high, context, pair, &asked, at + 3, GRAZE_STATE_O);
}

/* Is a motion one that keeps all lengths, or none? */
static int keeps_lengths(const graze_motion *motion) {
    LOCAL_VEC(fmpz_poly, square, 2);
    int keeps = 1;
    for (size_t k = 0; motion && keeps && k < motion->piece_count; k++) {
        const point_map *map = &motion->piece[k].forward;
        keeps = point_map_scale(square, map);
        fmpz_poly_sqr(square + 1, map->weight);
        keeps = keeps && fmpz_poly_equal(square, square + 1);
    }
    return keeps;
}

/* Write the half-space of the points deeper than a length behind the plane of a simplex, or by up
 * to 2^-40 of the length deeper; 0 if a vertex of the solid is before the plane. */
static int put_deeper(text *out, const graze_solid *of, size_t simplex, const fmpq_t length) {
    int d = of->input.dimension, before = 0;
    LOCAL_VEC(fmpz, form, 8); /* then a vertex */
    LOCAL_VEC(fmpq, by, 2);
    _fmpz_vec_scalar_mul_si(form, form, d + 1, solid_plane(form, of, simplex));
    for (uint32_t v = 0; v < of->input.vertex_count && !before; v++) {
        homogeneous_vertex(form + 4, of, v);
        before = form_sign(form, form + 4, d) > 0;
    }
    _fmpz_vec_dot(fmpq_numref(by), form, form, d);
    fmpz_mul_2exp(fmpq_numref(by), fmpq_numref(by), 2 * HALVINGS);
    csg_upper_root(by + 1, by);
    fmpq_div_2exp(by + 1, by + 1, HALVINGS);
    fmpq_mul(by, by + 1, length);
    fmpq_add_fmpz(by, by, form + d);
    fmpq_neg(by, by);
    for (int i = 0; i < d; i++) {
        text_put(out, i ? ", " : ", {\"halfspace\": {\"normal\": [");
        text_integer(out, form + i);
    }
    text_put(out, "], \"offset\": \"");
    text_rational(out, by);
    text_put(out, "\"}}");
    return !before;
}

/* Make the solid of all points of a convex one that are deeper than a length; NULL if it is not
 * convex or has many facets. A solid without points is curved. */
static graze_status make_core(graze_solid **out, graze_context *context, const graze_solid *of,
                              const fmpq_t length) {
    const graze_context given = *context;
    int d = of->input.dimension, convex = of->cut.count <= MOST_FACETS;
    LOCAL_VEC(fmpq, box, 6);
    HELD(text, t);
    solid_box(box, box + d, of);
    text_format(&t, "{\"dimension\": %d, \"solid\": {\"intersection\": [{\"box\": {\"low\": [\"",
                d);
    for (int k = 0; k < 2 * d; k++) {
        text_put(&t, k == d ? "\"], \"high\": [\"" : k ? "\", \"" : "");
        text_rational(&t, box + k);
    }
    text_put(&t, "\"]}}");
    for (size_t k = 0; k < of->cut.count && convex; k++)
        convex = put_deeper(&t, of, k, length);
    text_put(&t, "]}}");
    if (!convex || t.failed)
        return t.failed ? context_fail(context, GRAZE_ESYSTEM, "out of memory") : GRAZE_OK;
    context->rounding = GRAZE_ROUND_NONE; /* its numbers are those of the solid */
    context->limits[GRAZE_LIMIT_DIGITS] = context->limits[GRAZE_LIMIT_LINE] = ULONG_MAX;
    graze_status status =
        solid_create_curved_text(out, context, "solid", t.data, t.length, of->input.sha256);
    context->rounding = given.rounding;
    memcpy(context->limits, given.limits, sizeof given.limits);
    return status;
}

/* Ask when points of one solid are deeper in the other one, if that is convex, has few facets and
 * keeps its lengths; *done tells that. */
static graze_status ask_core(int *done, graze_pair *pair, graze_context *context, int side) {
    solid_pair asked = pair->pair;
    const graze_solid **other = side ? &asked.moving : &asked.fixed;
    graze_solid *core = NULL;
    LOCAL_VEC(fmpq, depth, 2); /* then 0 */
    if (asked.round[!side] || !keeps_lengths(pair->frame) ||
        (side && !keeps_lengths(pair->pair.motion)))
        return GRAZE_OK;
    fmpq_sub(depth, pair->error, pair->distance);
    graze_status status = make_core(&core, context, *other, depth);
    *done = core && (!core->curved || core->curved->form == CSG_EMPTY);
    *other = core;
    if (!status && *done && !core->curved)
        status = ask_entry(&pair->high, context, pair, &asked, depth + 1, GRAZE_STATE_I);
    graze_solid_destroy(core);
    return status;
}

/* Ask about vertices and centres of simplices. */
static graze_status ask_cells(graze_pair *pair, graze_context *context, int side) {
    const graze_solid *own = side ? pair->pair.fixed : pair->pair.moving;
    size_t vertices = own->input.vertex_count, count = vertices + own->cut.count;
    LOCAL_VEC(fmpz, x, 4);
    for (size_t k = 0; k < count; k += count / MOST_ASKED + 1) {
        if (k < vertices)
            homogeneous_vertex(x, own, (uint32_t)k);
        else
            solid_point_within(x, own, k - vertices, 1);
        TRY(ask_depth(pair, context, side, x));
    }
    return GRAZE_OK;
}

/* Ask about the mean of each solid's points that touch when the interiors begin to meet. */
static graze_status ask_touching(graze_pair *pair, graze_context *context) {
    int d = pair->pair.motion->dimension;
    double size = fmin(box_extent(&pair->pair.moving->boxes.node[0].box), 0x1p900);
    ZEROED(feature_list, list);
    algebraic *time = &pair->begun->u; /* narrowed, which does not change it */
    LOCAL_VEC(fmpq, map, POINT_MAP_ENTRIES);
    LOCAL_VEC(fmpq, mean, 9); /* of both in the fixed solid's space, then in the moving one's */
    LOCAL_VEC(fmpq, u, 3);
    LOCAL_VEC(fmpz, x, 4);
    for (int k = 0; k < HALVINGS && !algebraic_is_rational(time); k++)
        algebraic_refine(time);
    algebraic_bounds(u, u + 1, time);
    TRY(rational_from_double(u + 2, context, 0x1p-20 * size));
    HELD(clearance, about, u + 2);
    HELD(placing, p, context, &pair->pair, pair->begun->piece, u);
    p.near = &about;
    TRY(features_near(&list, &p));
    fmpq_set_ui(u + 1, 1, list.count + !list.count);
    for (size_t k = 0; k < list.count; k++) {
        LOCAL_VEC(fmpq, point, 6);
        HELD(stationary, found, &p, &list.item[k]);
        stationary_points(point, &p, &found);
        for (int i = 0; i < 6; i++)
            fmpq_addmul(mean + i, u + 1, point + i);
    }
    point_map_at(map, &pair->pair.motion->piece[pair->begun->piece].inverse, u);
    affine_image(mean + 6, map, mean, d);
    for (int side = 0; side < 2 && list.count; side++) {
        _fmpq_vec_get_fmpz_vec_fmpz(x, x + d, mean + (side ? 3 : 6), d);
        TRY(ask_depth(pair, context, side, x));
    }
    return GRAZE_OK;
}

graze_status collide_bound_first(graze_pair *pair, graze_context *context) {
    const pair_walk *walk = &pair->walk;
    int done[2] = {0, 0};     /* all points of a solid have been asked about */
    LOCAL_VEC(fmpq, less, 3); /* the clearance and its least sum with radii, less the error; 0 */
    pair->pair.near = NULL;   /* from here on there are others */
    fmpq_sub(pair->distance, pair->distance, pair->error);
    fmpq_sub(less, pair->distance, pair->error);
    clearance_least(less + 1, pair);
    fmpq_sub(less + 1, less + 1, pair->error);
    pair->bounds.low = pair->start || !walk->contact_count ? pair->start : walk->contact[0].from;
    if (pair->bounds.low && (fmpq_sgn(less) >= 0 || fmpq_sgn(less + 1) >= 0))
        TRY(ask_entry(&pair->high, context, pair, &pair->pair, less, GRAZE_STATE_I));
    else if (pair->bounds.low && (!pair->pair.round[0] || !pair->pair.round[1]))
        TRY(ask_entry(&pair->begun, context, pair, &pair->pair, less + 2, GRAZE_STATE_I));
    for (int side = 0; side < 2 && pair->begun; side++)
        TRY(ask_core(&done[side], pair, context, side));
    if (pair->begun && !pair->pair.round[0] && !pair->pair.round[1])
        TRY(ask_touching(pair, context));
    for (int side = 0; side < 2 && pair->begun; side++)
        if (!done[side] && !pair->pair.round[!side])
            TRY(ask_cells(pair, context, side));
    pair->bounds.high = pair->high;
    return pair->high ? time_canonicalise(pair->high, context) : GRAZE_OK;
}
