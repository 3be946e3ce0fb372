/* The time at which all motions near a given one have met at the latest (proofs/collision.md C147).
 * Each time at which a point is deep enough is such a bound. The points do not depend on the error,
 * so that enclosures are nested. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "input/planar/planar.h"
#include "questions/collide/near_pairs.h"

/* The most cells of a solid, evenly chosen, that give points; halvings of an irrational time, and
 * places of a root; the most planes of a convex solid whose depths are found for all points. */
enum { MOST_ASKED = 64, HALVINGS = 40, MOST_PLANES = 256 };

typedef graze_pair collide; /* as locals that collide_clear and planes_clear clear */
typedef plane_list planes;

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

/* Find the side of a plane on which a solid is: 1, -1, or 0 if it is on both. */
static int side_of_plane(const graze_solid *solid, const fmpz *form) {
    int d = solid->input.dimension, side = 0;
    LOCAL_VEC(fmpz, x, 4);
    for (size_t v = 0; v < solid->input.vertex_count; v++) {
        homogeneous_vertex(x, solid, (uint32_t)v);
        int next = form_sign(form, x, d);
        if (next * side < 0)
            return 0;
        side = next ? next : side;
    }
    return side;
}

/* Move the plane of a form towards `side` by a length, or by up to 2^-40 of it more. */
static void deepen_plane(fmpz *form, int side, const fmpq_t length, int d) {
    LOCAL_VEC(fmpq, by, 2);
    LOCAL(fmpz, content);
    _fmpz_vec_dot(fmpq_numref(by + 1), form, form, d);
    fmpz_mul_2exp(fmpq_numref(by + 1), fmpq_numref(by + 1), 2 * HALVINGS);
    csg_upper_root(by, by + 1);
    fmpq_div_2exp(by, by, HALVINGS);
    fmpq_mul(by, by, length);
    _fmpz_vec_scalar_mul_fmpz(form, form, d + 1, fmpq_denref(by));
    (side < 0 ? fmpz_add : fmpz_sub)(form + d, form + d, fmpq_numref(by));
    _fmpz_vec_content(content, form, d + 1);
    _fmpz_vec_scalar_divexact_fmpz(form, form, d + 1, content);
}

/* Make the solid of the points that are on given sides of planes, within the box of another one. */
static graze_status make_core(graze_solid **out, graze_context *context, const graze_solid *of,
                              const fmpz *form, const int *side, size_t count) {
    static unsigned char power[2][4][3] = {{{1}, {0, 1}}, {{1}, {0, 1}, {0, 0, 1}}};
    int d = of->input.dimension;
    csg_surface surface[MOST_PLANES];
    csg_node node[MOST_PLANES + 1] = {{.operation = CSG_SIGN}};
    size_t operand[2 * MOST_PLANES];
    csg solid = {.dimension = d, .surface = surface, .node = node, .operand = operand};
    csg_form kind;
    HELD(csg_box, box);
    soup facets;
    for (size_t k = 0; k < count; k++) {
        surface[k] =
            (csg_surface){1, (size_t)d + 1, (fmpz *)form + k * ((size_t)d + 1), power[d - 2]};
        node[k] = (csg_node){CSG_SIGN, side[k] > 0, k, 1, 0};
        operand[k] = operand[count + k] = k;
    }
    node[count] = (csg_node){CSG_ALL, 0, count, count, 0};
    solid.surface_count = count;
    solid.node_count = count + 1;
    solid.operand_count = 2 * count;
    box.dimension = d;
    solid_box(box.low, box.high, of);
    solid.box = box;
    context->work = 0;
    graze_status status = planar_soup(&facets, &kind, context, &solid);
    if (!status && kind == CSG_FACETS)
        return solid_create(out, context, &facets, 0);
    soup_clear(&facets);
    return status;
}

/* Ask when points of one solid are deeper in the other one, if that is convex, has few planes and
 * keeps its lengths; *done tells that. */
static graze_status ask_core(int *done, graze_pair *pair, graze_context *context, int side) {
    solid_pair asked = pair->pair;
    const graze_solid **other = side ? &asked.moving : &asked.fixed, *of = *other;
    size_t width = (size_t)pair->pair.motion->dimension + 1, k = 0;
    int at[MOST_PLANES], empty = 0;
    LOCAL_VEC(fmpq, depth, 2); /* then 0 */
    ZEROED(planes, list);
    *done = 0;
    if (asked.round[!side] || !keeps_lengths(pair->frame) ||
        (side && !keeps_lengths(pair->pair.motion)))
        return GRAZE_OK;
    if (planes_find(&list, NULL, of, NULL, of->cut.count))
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for planes");
    if (list.count > MOST_PLANES)
        return GRAZE_OK;
    fmpq_sub(depth, pair->error, pair->distance);
    for (; k < list.count; k++) {
        fmpz *form = list.form + k * width;
        at[k] = side_of_plane(of, form);
        if (!at[k])
            return GRAZE_OK;
        deepen_plane(form, at[k], depth, (int)width - 1);
        for (size_t i = 0; i < k; i++)
            empty |= form_compare(list.form + i * width, form, (int)width - 1) == 0;
    }
    *done = 1;
    *other = NULL;
    graze_status status =
        empty ? GRAZE_OK : make_core((graze_solid **)other, context, of, list.form, at, k);
    if (!status && *other)
        status = ask_entry(&pair->high, context, pair, &asked, depth + 1, GRAZE_STATE_I);
    graze_solid_destroy((graze_solid *)*other);
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
