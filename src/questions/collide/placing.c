/* Values of forms at carried vertices, and their signs. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "questions/collide/placing.h"

/* The motion's determinant never vanishes, so one time tells. */
int placing_mirrors(placing *p) {
    LOCAL_VEC(fmpq, value, POINT_MAP_ENTRIES);
    LOCAL(fmpq, start);
    if (!p->orientation) {
        point_map_at(value, &p->pair->motion->piece[0].forward, start);
        p->orientation = affine_orientation(value, p->pair->motion->dimension);
    }
    return p->orientation < 0;
}

/* Set the map at u, with constants as entries. */
static void freeze(point_map *out, const point_map *map, const fmpq_t u) {
    int n = map->dimension * (map->dimension + 1);
    LOCAL_VEC(fmpq, value, n);
    LOCAL_VEC(fmpz, entry, n + 1);
    point_map_init(out, map->dimension);
    point_map_at(value, map, u);
    _fmpq_vec_get_fmpz_vec_fmpz(entry, entry + n, value, n);
    for (int k = 0; k < n; k++)
        fmpz_poly_set_fmpz(&out->entry[k], entry + k);
    fmpz_poly_set_fmpz(out->weight, entry + n);
}

void placing_init(placing *p, graze_context *context, const solid_pair *pair, size_t piece,
                  const fmpq *u) {
    const motion_piece *m = &pair->motion->piece[piece];
    const point_map *map[] = {[SIDE_MOVING] = &m->forward, [SIDE_FIXED] = &m->inverse};
    *p = (placing){.pair = pair, .context = context, .is_frozen = u != NULL, .piece = piece};
    p->near = pair->near ? &pair->near[piece] : NULL;
    if (p->near && u) {
        clearance_freeze(&p->frozen_near, p->near, u);
        p->near = &p->frozen_near;
    }
    for (int side = 0; side < 2; side++) {
        if (u)
            freeze(&p->frozen[side], map[side], u);
        p->map[side] = u ? &p->frozen[side] : map[side];
    }
}

void placing_set_time(placing *p, algebraic *when) {
    p->when = when;
    p->known.count = 0;
}

void placing_clear(placing *p) {
    if (p->near == &p->frozen_near)
        clearance_clear(&p->frozen_near);
    for (int k = 0; k < KNOWN_SIGNS; k++)
        fmpz_poly_clear(&p->known.of[k]);
    _fmpz_vec_zero(p->room, 12);
    fmpz_poly_clear(p->value);
    fmpz_poly_clear(p->product);
    for (int side = 0; side < 2; side++) {
        placed_vertices *v = &p->vertices[side];
        for (size_t k = 0; k < v->index.count; k++) {
            trajectory_clear(v->at[k]);
            free(v->at[k]);
        }
        free(v->vertex);
        free(v->at);
        slots_clear(&v->index);
        if (p->is_frozen)
            point_map_clear(&p->frozen[side]);
    }
}

const graze_solid *placing_solid(const placing *p, pair_side side) {
    return side == SIDE_MOVING ? p->pair->moving : p->pair->fixed;
}

/* Append a vertex to a cache: to its index and its array, with a new trajectory. */
static trajectory *add_vertex(placing *p, pair_side side, uint32_t vertex) {
    placed_vertices *v = &p->vertices[side];
    size_t count = v->index.count, capacity = v->capacity;
    trajectory *made = malloc(sizeof *made);
    if (!made || !array_reserve(&v->vertex, &capacity, count + 1, sizeof *v->vertex) ||
        !array_reserve(&v->at, &v->capacity, count + 1, sizeof(trajectory *)) ||
        !slots_add(&v->index, slots_mix(vertex))) {
        free(made);
        p->status = context_fail(p->context, GRAZE_ESYSTEM, "out of memory for moved vertices");
        return NULL;
    }
    int d = p->pair->motion->dimension;
    trajectory_init(made, d);
    trajectory_set(made, p->map[side],
                   placing_solid(p, side)->input.coordinates + vertex * (size_t)d);
    v->vertex[count] = vertex;
    v->at[count] = made;
    return made;
}

const trajectory *placing_vertex(placing *p, pair_side side, uint32_t vertex) {
    const placed_vertices *v = &p->vertices[side];
    uint64_t hash = slots_mix(vertex);
    for (size_t at = 0, k; (k = slots_next(&v->index, hash, &at)) != SLOTS_NONE;)
        if (v->vertex[k] == vertex)
            return v->at[k];
    return add_vertex(p, side, vertex);
}

static void pull_to_vertex(fmpz_poly_t out, placing *p, pair_side side, const fmpz *form,
                           uint32_t vertex) {
    const trajectory *c = placing_vertex(p, (pair_side)!side, vertex);
    if (c)
        trajectory_pullback(out, c, form);
    else
        fmpz_poly_zero(out);
}

void placing_plane(fmpz_poly_t out, placing *p, pair_side side, uint32_t simplex, uint32_t vertex) {
    known_plane(p->room, p->pair->forms[side], placing_solid(p, side), simplex);
    pull_to_vertex(out, p, side, p->room, vertex);
}

void placing_side(fmpz_poly_t out, placing *p, pair_side side, uint32_t simplex, int k,
                  uint32_t vertex) {
    const graze_solid *solid = placing_solid(p, side);
    form_memory *forms = p->pair->forms[side];
    known_plane(p->room, forms, solid, simplex);
    pull_to_vertex(out, p, side, known_side(p->room + 4, forms, solid, simplex, p->room, k),
                   vertex);
}

void homogeneous_vertex(fmpz *out, const graze_solid *solid, uint32_t vertex) {
    slong d = solid->input.dimension;
    _fmpq_vec_get_fmpz_vec_fmpz(out, out + d, solid->input.coordinates + vertex * (size_t)d, d);
}

/* det(a, b, p, q) is the sum over i < j of (a_i b_j - a_j b_i) k_ij, where k_ij is the
 * complementary minor of p and q; this is a K b with a skew matrix K. */
void placing_edges(fmpz_poly_t out, placing *p, const uint32_t moving[2], const uint32_t fixed[2]) {
    static const int other[4][4][2] = {{{0, 0}, {2, 3}, {3, 1}, {1, 2}},
                                       {{3, 2}, {0, 0}, {0, 3}, {2, 0}},
                                       {{1, 3}, {3, 0}, {0, 0}, {0, 1}},
                                       {{2, 1}, {0, 2}, {1, 0}, {0, 0}}};
    const trajectory *a = placing_vertex(p, SIDE_MOVING, moving[0]);
    const trajectory *b = a ? placing_vertex(p, SIDE_MOVING, moving[1]) : NULL;
    fmpz *end = p->room, *row = end + 8;
    fmpz_poly_zero(out);
    homogeneous_vertex(end, p->pair->fixed, fixed[0]);
    homogeneous_vertex(end + 4, p->pair->fixed, fixed[1]);
    for (int i = 0; i < 4 && b; i++) {
        for (int j = 0; j < 4; j++) {
            const int *m = other[i][j];
            fmpz_mul(row + j, end + m[0], end + 4 + m[1]);
            fmpz_submul(row + j, end + m[1], end + 4 + m[0]);
        }
        trajectory_pullback(p->product, b, row);
        fmpz_poly_mul(p->product, p->product, &a->x[i]);
        fmpz_poly_add(out, out, p->product);
    }
}

/* Each zero sign narrows the time a little, and a time may have thousands of them, so it is not
 * narrowed beyond MOST_PLACES binary places. */
enum { MOST_PLACES = 200 };

static int sign_at_root(placing *p, const fmpz_poly_t q) {
    int sign = 0;
    HELD(algebraic, time);
    algebraic_set(&time, p->when);
    p->status = algebraic_sign_at(&sign, p->context, q, &time);
    if (algebraic_is_rational(&time) || time.where.exponent <= MOST_PLACES)
        algebraic_set(p->when, &time);
    return sign;
}

/* The sign of a primitive polynomial with a positive leading coefficient, through the cache. */
static int known_sign(placing *p, const fmpz_poly_t q) {
    known_signs *known = &p->known;
    size_t kept = known->count < KNOWN_SIGNS ? known->count : KNOWN_SIGNS;
    for (size_t k = 0; k < kept; k++)
        if (fmpz_poly_equal(&known->of[k], q))
            return known->sign[k];
    if (p->status)
        return 0;
    size_t at = known->count++ % KNOWN_SIGNS;
    fmpz_poly_set(&known->of[at], q);
    known->sign[at] = sign_at_root(p, q);
    return known->sign[at];
}

int placing_sign(placing *p, const fmpz_poly_t q) {
    if (fmpz_poly_length(q) <= 1)
        return fmpz_poly_is_zero(q) ? 0 : fmpz_sgn(q->coeffs);
    LOCAL(fmpz_poly, part);
    fmpz_poly_primitive_part(part, q);
    int sign = known_sign(p, part);
    return fmpz_sgn(fmpz_poly_lead(q)) * sign;
}

int placing_plane_sign(placing *p, pair_side side, uint32_t simplex, uint32_t vertex) {
    placing_plane(p->value, p, side, simplex, vertex);
    return placing_sign(p, p->value);
}

int placing_side_sign(placing *p, pair_side side, uint32_t simplex, int k, uint32_t vertex) {
    placing_side(p->value, p, side, simplex, k, vertex);
    return placing_sign(p, p->value);
}

int placing_edges_sign(placing *p, const uint32_t moving[2], const uint32_t fixed[2]) {
    placing_edges(p->value, p, moving, fixed);
    return placing_sign(p, p->value);
}

int placing_inside(unsigned *zero, placing *p, pair_side side, uint32_t simplex, uint32_t vertex) {
    *zero = 0;
    for (int k = 0; k < p->pair->motion->dimension; k++) {
        int sign = placing_side_sign(p, side, simplex, k, vertex);
        if (sign < 0 || p->status)
            return 0;
        *zero |= sign == 0 ? 1u << k : 0;
    }
    return 1;
}

int placing_in_interior(placing *p, pair_side side, uint32_t vertex) {
    int d = p->pair->motion->dimension, inside = 0;
    if (p->pair->round[!side])
        return 0;
    const trajectory *c = placing_vertex(p, side, vertex);
    LOCAL_VEC(fmpz, x, d + 1);
    for (int i = 0; i <= d && c; i++)
        fmpz_poly_get_coeff_fmpz(x + i, &c->x[i], 0);
    if (c) {
        graze_state state = solid_locate(placing_solid(p, (pair_side)!side), x);
        if (state == GRAZE_STATE_ABSENT)
            p->status = context_fail(p->context, GRAZE_EINTERNAL,
                                     "the crossings of a ray through a solid do not add up");
        int turned = p->pair->complement == (side == SIDE_MOVING ? 1 : 2);
        inside = state == (turned ? GRAZE_STATE_O : GRAZE_STATE_I);
    }
    return inside;
}
