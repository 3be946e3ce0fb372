/* Pairs of features, whose equation, feet and cells come from the vectors that span them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "questions/collide/features.h"

/* Numbers of corners of two faces, by their sum. */
static const int kinds[][2] = {{1, 1}, {1, 2}, {2, 1}, {2, 2}, {1, 3}, {3, 1}, {2, 3}, {3, 2}};

int features_first(const placing *p) {
    return p->near ? 0 : p->pair->motion->dimension == 3 ? 3 : 1;
}

int features_end(const placing *p) {
    return p->pair->motion->dimension == 3 ? 6 : 3;
}

/* A face of a simplex and the sorted numbers of its vertices. */
typedef struct named_face {
    corner_run run;
    uint32_t key[3];
} named_face;

static uint32_t run_vertex(const placing *p, pair_side side, corner_run run, int k) {
    const simplex *s = &placing_solid(p, side)->cut.item[run.simplex];
    return s->vertex[(run.first + k) % p->pair->motion->dimension];
}

static void add_named_face(named_face out[3], int *found, const placing *p, pair_side side,
                           corner_run run) {
    named_face *f = &out[(*found)++];
    f->run = run;
    for (int k = 0; k < 3; k++) {
        uint32_t vertex = k < run.count ? run_vertex(p, side, run, k) : UINT32_MAX;
        int at = k;
        for (; at > 0 && f->key[at - 1] > vertex; at--)
            f->key[at] = f->key[at - 1];
        f->key[at] = vertex;
    }
}

/* Give the faces of a simplex with `count` corners. @return their number */
static int faces_of_simplex(named_face out[3], const placing *p, pair_side side, uint32_t simplex,
                            int count, int all) {
    int corners = simplex_corners(p, side, simplex), found = 0;
    unsigned made = all || !p->near || corners < 3 || count != 2
                        ? 0
                        : placing_solid(p, side)->cut.item[simplex].diagonal;
    if (count == corners)
        add_named_face(out, &found, p, side, (corner_run){simplex, 0, count});
    for (int k = 0; k < corners && count < corners; k++)
        if (!(made >> k & 1))
            add_named_face(out, &found, p, side, (corner_run){simplex, k, count});
    return found;
}

void features_add(feature_list *out, placing *p, near_pair simplices, int kind, int all) {
    named_face moving[3], fixed[3];
    int m = faces_of_simplex(moving, p, SIDE_MOVING, simplices.moving, kinds[kind][0], all);
    int n = faces_of_simplex(fixed, p, SIDE_FIXED, simplices.fixed, kinds[kind][1], all);
    for (int i = 0; i < m; i++)
        for (int j = 0; j < n && PLACING_ROOM(p, out, "pairs of features"); j++) {
            feature_pair *f = &out->item[out->count++];
            *f = (feature_pair){.of = {moving[i].run, fixed[j].run}};
            memcpy(f->key, moving[i].key, sizeof moving[i].key);
            memcpy(f->key + 3, fixed[j].key, sizeof fixed[j].key);
        }
}

static int compare_features(const void *left, const void *right) {
    const feature_pair *a = left, *b = right;
    for (int i = 0; i < 6; i++)
        if (a->key[i] != b->key[i])
            return a->key[i] < b->key[i] ? -1 : 1;
    return 0;
}

void features_gather(feature_list *out, placing *p, const near_list *near, int kind) {
    out->count = 0;
    for (size_t k = 0; k < near->count && !p->status; k++)
        features_add(out, p, near->item[k], kind, 0);
    out->count = array_sort_once(out->item, out->count, sizeof *out->item, compare_features);
}

/* Set the vector from a corner of the moving face to one of the fixed face, times `weight`, which
 * is positive. */
static void set_offset(moving_vector *out, fmpz_poly_t weight, placing *p, uint32_t moving,
                       uint32_t fixed) {
    int d = p->pair->motion->dimension;
    const trajectory *x = placing_vertex(p, SIDE_MOVING, moving);
    fmpz *y = p->room;
    if (!x)
        return;
    homogeneous_vertex(y, p->pair->fixed, fixed);
    for (int i = 0; i < d; i++) {
        fmpz_poly_scalar_mul_fmpz(&out->c[i], &x->x[d], y + i);
        fmpz_poly_scalar_mul_fmpz(p->product, &x->x[i], y + d);
        fmpz_poly_sub(&out->c[i], &out->c[i], p->product);
    }
    fmpz_poly_scalar_mul_fmpz(weight, &x->x[d], y + d);
}

/* Set the squared distance of the hulls, times the square of the offset's weight and the Gram
 * determinant of the vectors, and set that. */
static void set_distance(fmpz_poly_t out, stationary *s, const moving_vector *offset) {
    HELD(moving_vector, cross);
    LOCAL(fmpz_poly, height);
    if (s->count == 0) {
        fmpz_poly_one(s->gram);
        dot_moving(out, offset, offset);
    } else if (s->count == 1) {
        dot_moving(s->gram, &s->span[0], &s->span[0]);
        cross_moving(&cross, offset, &s->span[0]);
        dot_moving(out, &cross, &cross);
    } else {
        cross_moving(&cross, &s->span[0], &s->span[1]);
        dot_moving(s->gram, &cross, &cross);
        dot_moving(height, &cross, s->count == 2 ? offset : &s->span[2]);
        fmpz_poly_sqr(s->count == 2 ? out : s->gram, height);
    }
}

/* Divide by the common factors with the weight, which is positive. */
static void divide_out(fmpz_poly_t out, const fmpz_poly_t weight) {
    LOCAL(fmpz_poly, factor);
    fmpz_poly_gcd(factor, out, weight);
    while (fmpz_poly_degree(factor) > 0 && !fmpz_poly_is_zero(out)) {
        if (fmpz_sgn(fmpz_poly_lead(factor)) != fmpz_sgn(fmpz_poly_lead(weight)))
            fmpz_poly_neg(factor, factor);
        fmpz_poly_div(out, out, factor);
        fmpz_poly_gcd(factor, out, weight);
    }
}

static void set_stationary(stationary *s, placing *p) {
    uint32_t base[2];
    HELD(moving_vector, offset);
    LOCAL(fmpz_poly, least);
    LOCAL_VEC(fmpz_poly, near, 2);
    for (int side = 0; side < 2; side++) {
        corner_run run = s->features->of[side];
        base[side] = run_vertex(p, (pair_side)side, run, 0);
        for (int k = 1; k < run.count; k++)
            edge_vector(&s->span[s->count++], p, (pair_side)side, run.simplex, run.first,
                        (run.first + k) % p->pair->motion->dimension);
    }
    set_offset(&offset, p->value, p, base[SIDE_MOVING], base[SIDE_FIXED]);
    set_distance(s->equation, s, &offset);
    fmpz_poly_sqr(least, p->value);
    fmpz_poly_mul(least, least, s->gram);
    clearance_square(near, p->near, p->pair,
                     (near_pair){s->features->of[0].simplex, s->features->of[1].simplex});
    fmpz_poly_mul(s->equation, s->equation, &near[1]);
    fmpz_poly_mul(least, least, &near[0]);
    fmpz_poly_sub(s->equation, s->equation, least);
    divide_out(s->equation, p->map[SIDE_MOVING]->weight);
}

/* The side of the face of a vertex and a face. */
static pair_side side_of_face(const feature_pair *features) {
    return features->of[SIDE_MOVING].count == 1 ? SIDE_FIXED : SIDE_MOVING;
}

static int are_edges(const feature_pair *features) {
    return features->of[SIDE_MOVING].count == features->of[SIDE_FIXED].count;
}

static uint32_t single_vertex(const placing *p, const feature_pair *features) {
    pair_side other = (pair_side)!side_of_face(features);
    return run_vertex(p, other, features->of[other], 0);
}

/* Set the equation of features that span a plane together, without a clearance: it is linear in the
 * distance. */
static void set_incidence(stationary *s, placing *p) {
    const corner_run *run = s->features->of;
    uint32_t end[2][2];
    pair_side face = side_of_face(s->features);
    if (!are_edges(s->features)) {
        placing_plane(s->equation, p, face, run[face].simplex, single_vertex(p, s->features));
        return;
    }
    for (int side = 0; side < 2; side++)
        simplex_side(end[side], placing_solid(p, (pair_side)side), run[side].simplex,
                     run[side].first);
    placing_edges(s->equation, p, end[SIDE_MOVING], end[SIDE_FIXED]);
}

void stationary_init(stationary *s, placing *p, const feature_pair *features) {
    s->features = features;
    s->count = 0;
    fmpz_poly_init(s->gram);
    fmpz_poly_init(s->equation);
    for (int k = 0; k < 3; k++)
        moving_vector_init(&s->span[k]);
    (p->near ? set_stationary : set_incidence)(s, p);
}

int stationary_turns(fmpz_poly_t out, placing *p, const stationary *s, int k) {
    pair_side face = side_of_face(s->features);
    if (p->near || are_edges(s->features) || k == p->pair->motion->dimension)
        return 0;
    placing_side(out, p, face, s->features->of[face].simplex, k, single_vertex(p, s->features));
    return 1;
}

void stationary_clear(stationary *s) {
    for (int k = 0; k < 3; k++)
        moving_vector_clear(&s->span[k]);
    fmpz_poly_clear(s->gram);
    fmpz_poly_clear(s->equation);
}

/* Set `out` to the part of v that is perpendicular to up to two vectors, times a positive number at
 * the placing's time. */
static void perpendicular_part(moving_vector *out, placing *p, const moving_vector *v,
                               const moving_vector *other[2], int count) {
    HELD(moving_vector, cross);
    if (count == 0) {
        moving_set(out, v);
    } else if (count == 1) {
        cross_moving(&cross, v, other[0]);
        cross_moving(out, other[0], &cross);
    } else {
        cross_moving(out, other[0], other[1]);
        dot_moving(p->value, out, v);
        if (placing_sign(p, p->value) < 0)
            moving_negate(out);
    }
}

/* The sign of the share that a corner of one face has in the face's stationary point. */
static int foot_sign(placing *p, const stationary *s, pair_side side, int corner) {
    const corner_run *run = s->features->of, own = run[side];
    int d = p->pair->motion->dimension, n = own.count, others = 0;
    int at = (own.first + corner) % d, from = (own.first + (corner + 1) % n) % d;
    uint32_t base[2] = {run_vertex(p, SIDE_MOVING, run[0], 0),
                        run_vertex(p, SIDE_FIXED, run[1], 0)};
    const moving_vector *other[2];
    HELD(moving_vector, to);
    HELD(moving_vector, across);
    HELD(moving_vector, beside);
    HELD(moving_vector, offset);
    edge_vector(&to, p, side, own.simplex, from, at);
    if (n == 3) {
        edge_vector(&beside, p, side, own.simplex, from, (corner + 2) % 3);
        other[others++] = &beside;
    }
    for (int k = 0; k < s->count; k++)
        if ((k >= run[0].count - 1) != (side == SIDE_FIXED))
            other[others++] = &s->span[k];
    base[side] = run_vertex(p, side, own, (corner + 1) % n);
    set_offset(&offset, p->value, p, base[0], base[1]);
    perpendicular_part(&across, p, &to, other, others);
    dot_moving(p->value, &across, &offset);
    int sign = placing_sign(p, p->value);
    return side == SIDE_MOVING ? sign : -sign;
}

/* Are there stationary points in both closed faces at the placing's time? The vectors must be
 * independent then. */
static int stationary_inside(unsigned zero[2], placing *p, const stationary *s) {
    int d = p->pair->motion->dimension;
    for (int side = 0; side < 2; side++) {
        corner_run run = s->features->of[side];
        unsigned corners = run.count == 1 ? 1u << run.first : 0;
        for (int k = 0; k < run.count && run.count > 1; k++) {
            int sign = foot_sign(p, s, (pair_side)side, k);
            if (sign < 0 || p->status)
                return 0;
            corners |= sign ? 1u << (run.first + k) % d : 0;
        }
        zero[side] = sides_around(d, corners);
    }
    return 1;
}

void stationary_points(fmpq *point, placing *p, const stationary *s) {
    int d = p->pair->motion->dimension, n = s->count, own = s->features->of[SIDE_MOVING].count - 1;
    const corner_run *run = s->features->of;
    const trajectory *x = placing_vertex(p, SIDE_MOVING, run_vertex(p, SIDE_MOVING, run[0], 0));
    const fmpq *y =
        p->pair->fixed->input.coordinates + (ptrdiff_t)run_vertex(p, SIDE_FIXED, run[1], 0) * d;
    LOCAL(fmpq_mat, span, d, n);
    LOCAL(fmpq_mat, across, n, d);
    LOCAL(fmpq_mat, gram, n, n);
    LOCAL(fmpq_mat, way, d, 1);
    LOCAL(fmpq_mat, share, n, 1);
    for (int i = 0; i < d && x; i++) {
        for (int k = 0; k < n; k++)
            fmpz_poly_get_coeff_fmpz(fmpq_mat_entry_num(span, i, k), &s->span[k].c[i], 0);
        fmpz_poly_get_coeff_fmpz(fmpq_numref(point + i), &x->x[i], 0);
        fmpz_poly_get_coeff_fmpz(fmpq_denref(point + i), &x->x[d], 0);
        fmpq_canonicalise(point + i);
        fmpq_set(point + 3 + i, y + i);
        fmpq_sub(fmpq_mat_entry(way, i, 0), y + i, point + i);
    }
    fmpq_mat_transpose(across, span);
    fmpq_mat_mul(gram, across, span);
    fmpq_mat_mul(share, across, way);
    if (n)
        fmpq_mat_solve(share, gram, share);
    for (int i = 0; i < d; i++)
        for (int k = 0; k < n; k++)
            (k < own ? fmpq_addmul : fmpq_submul)(point + i + (k < own ? 0 : 3),
                                                  fmpq_mat_entry(span, i, k),
                                                  fmpq_mat_entry(share, k, 0));
}

int features_sign(unsigned zero[2], placing *p, const feature_pair *features) {
    HELD(stationary, s, p, features);
    int sign = placing_sign(p, s.equation);
    if (sign > 0 || (s.count > 1 && placing_sign(p, s.gram) == 0))
        return 1;
    return stationary_inside(zero, p, &s) ? sign : 1;
}

/* Are two parallel edges at the clearance, by an end of one whose foot is in the other? */
static int edge_ends_touch(placing *p, const feature_pair *edges) {
    int d = p->pair->motion->dimension, found = 0;
    unsigned zero[2];
    for (int side = 0; side < 2; side++)
        for (int end = 0; end < 2; end++) {
            feature_pair part = *edges;
            part.of[side].first = (part.of[side].first + end) % d;
            part.of[side].count = 1;
            found = found || features_sign(zero, p, &part) == 0;
        }
    return found;
}

/* Do two edges, whose lines are coplanar at the time, cross inside both? Only the signs of the
 * edges' ends at the other triangle's plane are found. */
static int edges_meet(placing *p, const feature_pair *edges) {
    int plane[2][3] = {{0}, {0}};
    const corner_run *run = edges->of;
    for (int side = 0; side < 2; side++) {
        int first = run[side].first, second = (first + 1) % 3;
        for (int k = 0; k < 2; k++)
            plane[side][k ? second : first] =
                placing_plane_sign(p, (pair_side)!side, run[!side].simplex,
                                   run_vertex(p, (pair_side)side, run[side], k));
        if (plane[side][first] * plane[side][second] > 0)
            return 0;
    }
    return edges_cross(p, (near_pair){run[0].simplex, run[1].simplex}, run[0].first, run[1].first,
                       plane);
}

int stationary_touches(placing *p, const stationary *s) {
    unsigned zero[2];
    int found = 0;
    if (p->near && s->count > 1 && placing_sign(p, s->gram) == 0) {
        found = edge_ends_touch(p, s->features);
    } else if (p->near) {
        found = stationary_inside(zero, p, s);
    } else if (are_edges(s->features)) {
        found = edges_meet(p, s->features);
    } else {
        pair_side face = side_of_face(s->features);
        found = placing_inside(zero, p, face, s->features->of[face].simplex,
                               single_vertex(p, s->features));
    }
    return found && !p->status;
}

graze_state features_look(placing *p, const near_list *near) {
    int d = p->pair->motion->dimension, least = 1;
    ZEROED(feature_list, list);
    int end = features_end(p) + d - 1;
    unsigned zero[2];
    for (int k = 0; k < end && least >= 0; k++) {
        features_gather(&list, p, near, k);
        for (size_t i = 0; i < list.count && least >= 0 && !p->status; i++) {
            int sign = features_sign(zero, p, &list.item[i]);
            least = sign < least ? sign : least;
            placing_poll(p, i);
        }
    }
    return least < 0 ? GRAZE_STATE_I : least ? GRAZE_STATE_O : GRAZE_STATE_B;
}
