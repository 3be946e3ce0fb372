/* Both solids at a time, exactly: signs of the forms of one at the vertices of the other.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Vertices of the moving solid are carried into the fixed one's space by the motion, those of the
 * fixed one into the moving one's by its inverse. Their places are polynomials of u, at a rational
 * time constants.
 */
#ifndef GRAZE_COLLIDE_PLACING_H
#define GRAZE_COLLIDE_PLACING_H

#include "base/context/slots.h"
#include "base/number/algebraic.h"
#include "decide/trace/trajectory.h"
#include "input/solid/known.h"
#include "questions/collide/solid_pair.h"

/** A solid, or its vertices. */
typedef enum pair_side { SIDE_MOVING = 0, SIDE_FIXED = 1 } pair_side;

/** Vertices of one solid in the space of the other, those that were asked for. */
typedef struct placed_vertices {
    slots index;
    size_t capacity;
    uint32_t *vertex;
    trajectory **at;
} placed_vertices;

/** Signs of polynomials at the time, those that were asked for last: neighbouring simplices share
 * vertices, planes and edges. */
enum { KNOWN_SIGNS = 64 };
typedef struct known_signs {
    size_t count; /* since the time was set */
    fmpz_poly_struct of[KNOWN_SIGNS];
    int sign[KNOWN_SIGNS];
} known_signs;

/** Answers of a placing without GRAZE_OK in `status`, the first failure, mean nothing. */
typedef struct placing {
    const solid_pair *pair;
    graze_context *context;
    graze_status status;
    const point_map *map[2]; /* which carries the vertices of a side */
    point_map frozen[2];     /* the same at a rational time */
    int is_frozen;
    placed_vertices vertices[2];
    form_memory forms[2];
    algebraic *when;
    known_signs known;
    int mirrored; /* the motion turns outside in */
} placing;

/** Both solids on a whole piece; a time is to be set before signs are asked for. */
void placing_init(placing *p, graze_context *context, const solid_pair *pair, size_t piece);
/** Both solids at a rational time of a piece. */
void placing_init_at(placing *p, graze_context *context, const solid_pair *pair, size_t piece,
                     const fmpq_t u);
void placing_clear(placing *p);

/** Signs are asked for at a time from now on: it is borrowed, and narrowed. */
void placing_set_time(placing *p, algebraic *when);

const graze_solid *placing_solid(const placing *p, pair_side side);

/** The simplex of the pair on one side. */
static inline uint32_t simplex_of(near_pair simplices, pair_side side) {
    return side == SIDE_MOVING ? simplices.moving : simplices.fixed;
}

/** The place of a vertex of a side in the other's space; NULL without memory. */
const trajectory *placing_vertex(placing *p, pair_side side, uint32_t vertex);

/** The plane form of a simplex of `side` at a vertex of the other side. */
void placing_plane(fmpz_poly_t out, placing *p, pair_side side, uint32_t simplex, uint32_t vertex);
/** The plane form of side k of a triangle, likewise. */
void placing_side(fmpz_poly_t out, placing *p, pair_side side, uint32_t simplex, int k,
                  uint32_t vertex);

/** The determinant of two edges' ends, a and b of the moving solid, p and q of the fixed
 * one (E^3), but for a positive factor: 0 where the edges lie in one plane. */
void placing_edges(fmpz_poly_t out, placing *p, const uint32_t moving[2], const uint32_t fixed[2]);

/** The sign of a polynomial at the time. */
int placing_sign(placing *p, const fmpz_poly_t q);
int placing_plane_sign(placing *p, pair_side side, uint32_t simplex, uint32_t vertex);
int placing_side_sign(placing *p, pair_side side, uint32_t simplex, int k, uint32_t vertex);
int placing_edges_sign(placing *p, const uint32_t moving[2], const uint32_t fixed[2]);

/** Is a vertex, which is in the plane of a simplex of `side` at the time, in the closed simplex?
 * @param[out] zero the sides that vanish there */
int placing_inside(unsigned *zero, placing *p, pair_side side, uint32_t simplex, uint32_t vertex);

/** Is a vertex of `side` in the other one's interior? Of a placing at a rational time. */
int placing_in_interior(placing *p, pair_side side, uint32_t vertex);

#endif
