/* States of directions by their signs.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Each cell of the arrangement of a cone's planes has a rational direction. Once the states of
 * these directions have been asked, the state of each vector of signs is known.
 */
#include "questions/topo/cover.h"

#include "base/context/scope.h"
#include "base/number/isolate.h"

void signs_pull_back_normal(fmpz_poly_struct *out, const point_map *map, const fmpz *normal) {
    int d = map->dimension;
    for (int column = 0; column < d; column++) {
        fmpz_poly_zero(out + column);
        for (int row = 0; row < d; row++)
            fmpz_poly_scalar_addmul_fmpz(out + column, &map->entry[row * (d + 1) + column],
                                         normal + row);
    }
}

void signs_pull_back(fmpz_poly_t out, const point_map *map, const fmpz *normal,
                     const fmpz *direction) {
    int d = map->dimension;
    LOCAL(fmpz, factor);
    fmpz_poly_zero(out);
    for (int row = 0; row < d; row++)
        for (int column = 0; column < d; column++) {
            fmpz_mul(factor, normal + row, direction + column);
            fmpz_poly_scalar_addmul_fmpz(out, &map->entry[row * (d + 1) + column], factor);
        }
}

/* Ask the state of a direction in every cell of the arrangement. */
static graze_status learn_all(local_cone *cone, graze_context *context) {
    slong d = cone->dimension;
    graze_state state;
    int refused = 0;
    HELD(borders, b, (int)d);
    LOCAL_VEC(fmpz, none, d);
    TRY(cone_state(&state, cone, context, none));
    TRY(borders_of_cone(&b, &refused, context, cone));
    for (size_t r = 0; r < b.ray_count && !refused; r++) {
        HELD(ray_cells, cells, &b, r);
        TRY(cone_state(&state, cone, context, b.ray + r * (size_t)d));
        for (size_t k = 0; k < cells.count; k++)
            TRY(cone_state(&state, cone, context, cells.item + k * (size_t)d));
    }
    cone->knows_all = !refused;
    return GRAZE_OK;
}

graze_status signs_state(graze_state *out, local_cone *cone, graze_context *context,
                         const signed char *signs) {
    if (cone_knows(out, cone, signs))
        return GRAZE_OK;
    *out = GRAZE_STATE_B;
    if (!cone->knows_all)
        TRY(learn_all(cone, context));
    if (cone->knows_all && !cone_knows(out, cone, signs))
        return context_fail(context, GRAZE_EINTERNAL,
                            "a cell next to a contact is not found among those of its planes");
    return GRAZE_OK;
}

/* A plane that is crossed at a positive s, with its rank by s; planes crossed at the same s have
 * one rank. */
typedef struct plane_cut {
    size_t plane;
    int rank;
} plane_cut;

/* The values of a germ's planes at u + s e, as functions of s with coefficients that are
 * polynomials at the root. */
typedef struct root_sweep {
    germ *g;
    graze_context *context;
    size_t count;
    fmpz_poly_struct *at, *way; /* planes' values at u, and along e after the time */
    signed char *at_sign, *way_sign, *sign;
    plane_cut *cut; /* in order of s */
    size_t cut_count;
} root_sweep;

/* Set the planes' values at a direction about the point, and the signs of `at` and `way`. */
static graze_status set_values(root_sweep *s, const fmpz *direction) {
    const local_cone *cone = &s->g->cone;
    for (size_t j = 0; j < s->count; j++) {
        int sign = 0;
        signs_pull_back(s->at + j, s->g->map, cone->normal + j * (size_t)cone->dimension,
                        direction);
        TRY(algebraic_sign_at(&sign, s->context, s->at + j, &s->g->root->time));
        s->at_sign[j] = (signed char)sign;
        TRY(algebraic_sign_at(&sign, s->context, s->way + j, &s->g->root->time));
        s->way_sign[j] = (signed char)sign;
    }
    return GRAZE_OK;
}

/* Is plane j crossed before plane k (-1), together with k (0), or after k (1)? Plane j is crossed
 * at s = -at_j / way_j, times `side`. */
static graze_status compare_crossing_places(int *out, root_sweep *s, int side, size_t j, size_t k) {
    LOCAL(fmpz_poly, a);
    cross_terms(a, s->at + k, s->at + j, s->way + k, s->way + j);
    TRY(algebraic_sign_at(out, s->context, a, &s->g->root->time));
    *out *= side * s->way_sign[j] * s->way_sign[k];
    return GRAZE_OK;
}

/* Sort the planes that are crossed on a side by the s of their crossings. */
static graze_status order_crossings(root_sweep *s, int side) {
    s->cut_count = 0;
    for (size_t j = 0; j < s->count; j++) {
        size_t place = s->cut_count;
        int order = -1, rank = 0;
        if (s->at_sign[j] * s->way_sign[j] * side >= 0)
            continue;
        while (place > 0 && order < 0) {
            TRY(compare_crossing_places(&order, s, side, j, s->cut[place - 1].plane));
            place -= order < 0;
        }
        rank = place == 0 ? 0 : s->cut[place - 1].rank + (order > 0);
        int together = place > 0 && order == 0;
        for (size_t k = s->cut_count; k > place; k--) {
            s->cut[k] = s->cut[k - 1];
            s->cut[k].rank += !together;
        }
        s->cut[place] = (plane_cut){j, rank};
        s->cut_count++;
    }
    return GRAZE_OK;
}

/* Ask the state at the cuts of a rank; rank -1 stands for the places before all cuts. Cuts suffice:
 * the cone is closed, so a place between two cuts is in it only if the cuts beside it are. */
static graze_status look_at_rank(int *covered, root_sweep *s, int side, int rank) {
    graze_state state = GRAZE_STATE_O;
    for (size_t j = 0; j < s->count; j++)
        s->sign[j] = s->at_sign[j] ? s->at_sign[j] : (signed char)(side * s->way_sign[j]);
    for (size_t k = 0; k < s->cut_count && s->cut[k].rank <= rank; k++) {
        size_t j = s->cut[k].plane;
        s->sign[j] = s->cut[k].rank < rank ? (signed char)(side * s->way_sign[j]) : (signed char)0;
    }
    TRY(signs_state(&state, &s->g->cone, s->context, s->sign));
    *covered = *covered || state != GRAZE_STATE_O;
    return GRAZE_OK;
}

/* Ask all u + s e with s > 0 on one side; `side` is the sign of `way` there. */
static graze_status look_at_side(int *covered, root_sweep *s, int side) {
    TRY(order_crossings(s, side));
    int last = s->cut_count > 0 ? s->cut[s->cut_count - 1].rank : -1;
    for (int rank = -1; rank <= last && !*covered; rank++)
        TRY(look_at_rank(covered, s, side, rank));
    return GRAZE_OK;
}

graze_status signs_cover_at_root(int *covered, germ *g, graze_context *context,
                                 const fmpz *direction, int part) {
    size_t n = g->cone.count;
    graze_state state = GRAZE_STATE_O;
    LOCAL_VEC(fmpz_poly, at, (slong)n);
    FREED(signed char, sign, calloc(3 * n + 1, 1));
    FREED(plane_cut, cut, malloc((n + 1) * sizeof *cut));
    root_sweep s = {.g = g, .context = context, .count = n, .at = at, .way = g->root->way};
    *covered = 0;
    if (!sign || !cut)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a contact");
    s.at_sign = sign;
    s.way_sign = sign + n;
    s.sign = sign + 2 * n;
    s.cut = cut;
    TRY(set_values(&s, direction));
    TRY(signs_state(&state, &g->cone, context, s.at_sign));
    *covered = state != GRAZE_STATE_O;
    for (int k = 0; k < g->side_count && !*covered; k++)
        if (part == GERM_WHOLE || part == k)
            TRY(look_at_side(covered, &s, k > 0 && g->side[k].order % 2 == 1 ? -1 : 1));
    return GRAZE_OK;
}

/* Ask the state at one time. */
static graze_status look_at_time(int *covered, local_cone *cone, graze_context *context,
                                 const fmpz_poly_struct *p, signed char *sign, algebraic *time) {
    graze_state state = GRAZE_STATE_O;
    for (size_t j = 0; j < cone->count; j++) {
        int at = 0;
        TRY(algebraic_sign_at(&at, context, p + j, time));
        sign[j] = (signed char)at;
    }
    TRY(signs_state(&state, cone, context, sign));
    *covered = *covered || state != GRAZE_STATE_O;
    return GRAZE_OK;
}

/* Ask the state between two times. */
static graze_status look_between(int *covered, local_cone *cone, graze_context *context,
                                 const fmpz_poly_struct *p, signed char *sign, algebraic *from,
                                 algebraic *to) {
    HELD(algebraic, middle);
    TRY(algebraic_between(middle.value, context, from, to));
    return look_at_time(covered, cone, context, p, sign, &middle);
}

/* Ask the states at all roots inside the stretch, and between these and the stretch's ends. */
static graze_status look_at_roots(int *covered, turning_stretch *t, local_cone *cone,
                                  graze_context *context, const fmpz_poly_struct *p,
                                  signed char *sign, algebraic_list *roots) {
    algebraic *last = &t->from;
    for (size_t k = 0; k < roots->count && !*covered; k++) {
        int after = 0, before = 0;
        TRY(algebraic_compare(&after, context, &roots->item[k], &t->from));
        TRY(algebraic_compare(&before, context, &roots->item[k], &t->to));
        if (after <= 0 || before >= 0)
            continue;
        TRY(look_between(covered, cone, context, p, sign, last, &roots->item[k]));
        TRY(look_at_time(covered, cone, context, p, sign, &roots->item[k]));
        last = &roots->item[k];
    }
    return *covered ? GRAZE_OK : look_between(covered, cone, context, p, sign, last, &t->to);
}

graze_status signs_cover_in_turn(int *covered, turning_stretch *t, germ *g, graze_context *context,
                                 const fmpz *direction) {
    local_cone *cone = &g->cone;
    size_t n = cone->count;
    *covered = 0;
    LOCAL_VEC(fmpz_poly, p, (slong)n);
    FREED(signed char, sign, NULL);
    TRY(MAKE_ARRAY(context, sign, n + 1, "a contact"));
    LOCAL(fmpz_poly, product);
    fmpz_poly_set_ui(product, 1);
    HELD(algebraic_list, roots);
    for (size_t j = 0; j < n; j++) {
        signs_pull_back(p + j, g->map, cone->normal + j * (size_t)cone->dimension, direction);
        if (!fmpz_poly_is_zero(p + j))
            fmpz_poly_mul(product, product, p + j);
    }
    TRY(algebraic_roots(&roots, context, product, &unit_interval));
    return look_at_roots(covered, t, cone, context, p, sign, &roots);
}
