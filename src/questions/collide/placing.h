/* Both solids at a time, exactly: signs of one solid's forms at the other's vertices.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The motion carries vertices of the moving solid into the fixed solid's space; its inverse carries
 * vertices of the fixed solid into the moving solid's. Their places are polynomials in u, at a
 * rational time constants.
 */
#ifndef GRAZE_COLLIDE_PLACING_H
#define GRAZE_COLLIDE_PLACING_H

#include "base/context/slots.h"
#include "base/number/algebraic.h"
#include "decide/trace/trajectory.h"
#include "input/solid/known.h"
#include "questions/collide/solid_pair.h"

/** The moving or the fixed solid. */
typedef enum pair_side { SIDE_MOVING = 0, SIDE_FIXED = 1 } pair_side;

/** A cache of places of one solid's vertices in the other's space. */
typedef struct placed_vertices {
    slots index;
    size_t capacity;
    uint32_t *vertex;
    trajectory **at;
} placed_vertices;

/** A cache of the last signs of polynomials at the time: adjacent simplices share vertices, planes
 * and edges. */
enum { KNOWN_SIGNS = 64 };
typedef struct known_signs {
    size_t count; /* signs kept since the time was set */
    fmpz_poly_struct of[KNOWN_SIGNS];
    int sign[KNOWN_SIGNS];
} known_signs;

/** A placing. `status` is the first failure; its answers are invalid unless that is GRAZE_OK. */
typedef struct placing {
    const solid_pair *pair;
    graze_context *context;
    graze_status status;
    const point_map *map[2]; /* for each side, the map that carries its vertices */
    point_map frozen[2];     /* these maps at a rational time */
    int is_frozen;
    placed_vertices vertices[2];
    form_memory forms[2];
    algebraic *when;
    known_signs known;
    int mirrored; /* the motion reverses orientation */
} placing;

/** Place both solids on a whole piece; the caller sets a time before it asks for signs. */
void placing_init(placing *p, graze_context *context, const solid_pair *pair, size_t piece);
/** Place both solids at a rational time of a piece. */
void placing_init_at(placing *p, graze_context *context, const solid_pair *pair, size_t piece,
                     const fmpq_t u);
void placing_clear(placing *p);

/** Set the time of signs; it is borrowed, and questions narrow it. */
void placing_set_time(placing *p, algebraic *when);

const graze_solid *placing_solid(const placing *p, pair_side side);

/** The simplex of the pair on one side. */
static inline uint32_t simplex_of(near_pair simplices, pair_side side) {
    return side == SIDE_MOVING ? simplices.moving : simplices.fixed;
}

/** The place of a vertex of `side` in the other solid's space; NULL if memory runs out. */
const trajectory *placing_vertex(placing *p, pair_side side, uint32_t vertex);

/** The value of the plane form of a simplex of `side` at a vertex of the other side. */
void placing_plane(fmpz_poly_t out, placing *p, pair_side side, uint32_t simplex, uint32_t vertex);
/** The value of the form of side k of a simplex of `side` at a vertex of the other side. */
void placing_side(fmpz_poly_t out, placing *p, pair_side side, uint32_t simplex, int k,
                  uint32_t vertex);

/** The determinant of the ends a, b of an edge of the moving solid and p, q of one of the fixed
 * solid (E^3), times a positive factor: it is 0 if the edges are coplanar. */
void placing_edges(fmpz_poly_t out, placing *p, const uint32_t moving[2], const uint32_t fixed[2]);

/** The sign of a polynomial at the time. */
int placing_sign(placing *p, const fmpz_poly_t q);
int placing_plane_sign(placing *p, pair_side side, uint32_t simplex, uint32_t vertex);
int placing_side_sign(placing *p, pair_side side, uint32_t simplex, int k, uint32_t vertex);
int placing_edges_sign(placing *p, const uint32_t moving[2], const uint32_t fixed[2]);

/** Is a vertex in a closed simplex of `side` at the time? It is in the simplex's plane.
 * @param[out] zero the sides that hold it */
int placing_inside(unsigned *zero, placing *p, pair_side side, uint32_t simplex, uint32_t vertex);

/** Is a vertex of `side` in the other solid's interior? The placing is at a rational time. */
int placing_in_interior(placing *p, pair_side side, uint32_t vertex);

#endif
