/* Cells of a pair placed at a time, and their common points.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_COLLIDE_PLACING_H
#define GRAZE_QUESTIONS_COLLIDE_PLACING_H

#include "base/context/array.h"
#include "base/context/slots.h"
#include "questions/collide/collide.h"

/* A moving solid and a fixed one. */

/** Two simplices that may meet, one of each boundary. */
typedef struct near_pair {
    uint32_t moving, fixed;
} near_pair;

typedef struct near_list {
    size_t count, capacity;
    near_pair *item;
} near_list;
void near_list_clear(near_list *list);

/* Both solids at a time, exactly: signs of one solid's forms at the other's vertices.
 *
 * The motion carries vertices of the moving solid into the fixed solid's space; its inverse
 * carries vertices of the fixed solid into the moving solid's. Their places are polynomials in u,
 * at a rational time constants. */

/** Clearances with ratios 1; at a time of a piece they are constants. */
void clearance_init(clearance *near, const fmpq *distance);
void clearance_clear(clearance *near);
void clearance_freeze(clearance *out, const clearance *near, const fmpq_t u);

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
    size_t count; /* signs found since the time was set; the last KNOWN_SIGNS are kept */
    fmpz_poly_struct of[KNOWN_SIGNS];
    int sign[KNOWN_SIGNS];
} known_signs;

/** A placing. `status` is its first failure; the answers of a placing are invalid unless that is
 * GRAZE_OK. */
typedef struct placing {
    const solid_pair *pair;
    graze_context *context;
    graze_status status;
    const point_map *map[2]; /* for each side, the map that carries its vertices */
    point_map frozen[2];     /* if is_frozen: both maps at the rational time */
    int is_frozen;
    placed_vertices vertices[2];
    algebraic *when;
    known_signs known;
    size_t piece;
    const clearance *near; /* NULL: 0 */
    clearance frozen_near;
    int orientation; /* of placing_mirrors; 0: not known yet */
    fmpz room[12];   /* scratch memory of one question, as are the next ones */
    fmpz_poly_t value, product;
} placing;

/** Place both solids at a rational time of a piece; or, if `u` is NULL, on the whole piece: then
 * the caller sets a time before it asks for signs. */
void placing_init(placing *p, graze_context *context, const solid_pair *pair, size_t piece,
                  const fmpq *u);
void placing_clear(placing *p);

/** Does the motion reverse orientation? */
int placing_mirrors(placing *p);

/** Set the time of signs; it is borrowed, and questions narrow it. */
void placing_set_time(placing *p, algebraic *when);

/** Make room for one more entry of a list; 0 after a failure, earlier or now. */
#define PLACING_ROOM(p, list, what)                                                                \
    (!(p)->status && !((p)->status = LIST_GROW((p)->context, list, what)))

/** Ask now and then, by the number of a step, whether the run is cancelled. */
static inline void placing_poll(placing *p, size_t step) {
    if (step % 64 == 63 && !p->status)
        p->status = context_poll(p->context);
}

const graze_solid *placing_solid(const placing *p, pair_side side);

/** The simplex of a pair that belongs to the solid `side`. */
static inline uint32_t simplex_of(near_pair simplices, pair_side side) {
    return side == SIDE_MOVING ? simplices.moving : simplices.fixed;
}

/** The place of a vertex of the solid `side` in the other solid's space; NULL if memory runs out.
 */
const trajectory *placing_vertex(placing *p, pair_side side, uint32_t vertex);

/** A vertex as d + 1 homogeneous integers, the last one positive. */
void homogeneous_vertex(fmpz *out, const graze_solid *solid, uint32_t vertex);

/** The value of the plane form of a simplex of the solid `side` at a vertex of the other solid. */
void placing_plane(fmpz_poly_t out, placing *p, pair_side side, uint32_t simplex, uint32_t vertex);
/** The value of the form of the simplex's side k at a vertex; the simplex is of the solid `side`,
 * the vertex of the other solid. */
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

/** Is a vertex of the other solid, which must lie in the plane of a simplex of the solid `side` at
 * the time, in that closed simplex?
 * @param[out] zero the simplex's sides that hold the vertex */
int placing_inside(unsigned *zero, placing *p, pair_side side, uint32_t simplex, uint32_t vertex);

/** Is a vertex of the solid `side` in the other solid's interior? The placing must be at a rational
 * time. */
int placing_in_interior(placing *p, pair_side side, uint32_t vertex);
/** As placing_in_interior at any time, at which the vertex is not on the other boundary. */
int placing_in_interior_then(placing *p, pair_side side, uint32_t vertex);

/* The common part of two simplices at a time, given by its corners. */

/** A corner is a vertex of the moving simplex in the fixed one, a vertex of the fixed one in the
 * moving one, or a crossing of two edges inside both. */
typedef enum corner_kind { CORNER_MOVING = 0, CORNER_FIXED = 1, CORNER_EDGES = 2 } corner_kind;

/** A corner; `zero` are the sides of the moving and of the fixed simplex that hold it
 * (src/input/validate/validate.h). */
typedef struct common_corner {
    corner_kind kind;
    unsigned zero[2];
    int at[2]; /* the side of each simplex, or the corner of that whose vertex it is */
} common_corner;

enum { MOST_CORNERS = 15 };

/** All corners of the common part of two closed simplices. `crossing`: an edge of one passes
 * through the other's relative interior from one side to the other. Then the solids' interiors meet
 * there, and corners may be missing (proofs/collision.md C109). */
typedef struct common_points {
    int crossing, count;
    common_corner item[MOST_CORNERS];
} common_points;

/** Find the corners at the placing's time. After a failure of the placing the result is invalid. */
void common_points_find(common_points *out, placing *p, near_pair simplices);

/** The sides of a simplex that hold the corners whose bits are set. */
unsigned sides_around(int d, unsigned corners);

/** Give the two vertices of side k of a triangle, or vertex k of a segment twice. */
void simplex_side(uint32_t out[2], const graze_solid *solid, uint32_t simplex, int k);
/** Give the vertices as simplex_side does, the one with the lower number first: a key of the edge.
 */
void simplex_edge(uint32_t out[2], const graze_solid *solid, uint32_t simplex, int k);

/** Do sides k and l of two triangles cross inside both? Their lines must lie in one plane.
 * @param plane signs of the moving triangle's corners at the fixed one's plane, then of the fixed
 * one's at the moving one's */
int edges_cross(placing *p, near_pair simplices, int k, int l, int plane[2][3]);

/* The motion during an interval of one piece, enclosed by the convex hull of affine maps in
 * doubles. */

/** At each time of the interval the motion is a convex combination of the maps (proofs/collision.md
 * C108). Each entry differs from the exact one by at most 2^-48 of its size, or 2^-900. */
typedef struct control_maps {
    int dimension;
    size_t count;       /* 0: no maps are known, and points may be anywhere */
    double *entry;      /* dimension * (dimension + 1) for each map */
    double *room;       /* scratch memory: nine numbers for each map */
    double shift;       /* bound of the absolute values of the rows' last entries */
    double slope;       /* bound of the sums of the absolute values of a row's other entries */
    double least, most; /* bounds of the clearance; both 0 if there is none */
} control_maps;

/** The Bernstein coefficients of a point map's entries and of its weight, all of one degree, on an
 * interval. */
typedef struct map_forms {
    int dimension;
    slong degree;
    bernstein_form form[POINT_MAP_ENTRIES + 1];
} map_forms;

void map_forms_init(map_forms *out, const point_map *map, const dyadic_interval *interval);
void map_forms_clear(map_forms *forms);
/** Restrict the forms to the left half of the interval, and make those of the right half. */
void map_forms_split(map_forms *forms, map_forms *right);

/** Set the maps. `out` is zeros before its first use; control_maps_clear frees it. @return 0 if
 * memory runs out */
int control_maps_set(control_maps *out, const map_forms *forms);
void control_maps_clear(control_maps *maps);

/** A box around all images of a box during the interval; all of space if no maps are known. */
void control_maps_bound(box *out, const control_maps *maps, const box *of);

/* A vertex of one solid that is in the other solid's interior for an interval of time: meanwhile
 * the state is I, whatever the boundaries do. */

/** An open interval of times of a piece in which the interiors meet, with an end of the piece if it
 * goes past that; both ends are 0 if none is known. */
typedef struct deep_interval {
    fmpq_t low, high;
} deep_interval;

/** Find the longest deep interval around the middle of `interval` that a few vertices of the pairs
 * give.
 * @param whole a placing on the whole piece */
graze_status deep_vertex_find(deep_interval *out, placing *whole, size_t piece,
                              const near_list *near, const dyadic_interval *interval);

/* Times of an interval at which an incidence can begin or end: a vertex of one solid in a simplex
 * of the other, or a crossing of two edges. */

/** Find times in a closed interval of a piece such that between two of them the result of
 * common_points_find does not change for any pair, and at each of them some pair has a common
 * point. Of a contact that lasts, only the times are found at which its incidences change
 * (proofs/collision.md C110). With a clearance: no state changes between the times, and at each
 * some pair is at the clearance (C132).
 * @param[out] out the times, ascending, without duplicates
 * @param p a placing on the whole piece
 * @param maps the motion during the interval, for tests in doubles */
graze_status incidences_find(algebraic_list *out, placing *p, const near_list *near,
                             const control_maps *maps, const dyadic_interval *interval);

/* The state of a pair at one time, at which the boundaries may meet. */

/** The state of the pair at the placing's time: I, B or O (proofs/collision.md C109, C111; with a
 * clearance C131). The time is rational, or the boundaries meet at it or are at the clearance.
 * After a failure of the placing the result is invalid.
 * @param near all pairs of simplices that meet then, and perhaps others
 * @param before a placing at a rational time such that between both times no vertex off the other
 * boundary changes its state, or NULL at a rational time; not used with a clearance */
graze_state interiors_look(placing *p, const near_list *near, placing *before);

/* Do the interiors of two solids' local cones at a common point meet? A cone is given by the
 * sectors that bound the cone.
 *
 * Vectors are polynomials in u; only their directions at the placing's time matter. */

typedef struct moving_vector {
    fmpz_poly_struct c[3];
} moving_vector;

/** The positive combinations of `from` and `to`, which are independent; `normal` = from x to points
 * out of the cone. */
typedef struct sector {
    moving_vector from, to, normal;
} sector;

/** The sectors that bound a regular closed cone; they meet only in their ends. */
typedef struct sectors_about {
    size_t count, capacity;
    sector *item;
} sectors_about;

void sectors_about_clear(sectors_about *list);

/** Append the sectors that a simplex of `side` has at one of its points, in the fixed solid's
 * space.
 * @param zero the sides of the simplex that hold the point */
void sectors_about_add(sectors_about *list, placing *p, pair_side side, uint32_t simplex,
                       unsigned zero);

/** Do two open cones have a common direction (proofs/collision.md C111)? 0 after a failure. */
int open_cones_meet(placing *p, const sectors_about *a, const sectors_about *b);

/* The star of a point of an edge: the closed simplices of the edge's solid that hold the point. */

/** A simplex of the star, and its sides that hold the point. */
typedef struct star_simplex {
    uint32_t simplex;
    unsigned zero;
} star_simplex;

typedef struct star {
    size_t count, capacity;
    star_simplex *item;
} star;

/** Find all closed simplices of one solid that hold, at the placing's time, a point of an edge of
 * that solid.
 * @param edge the edge's ends, or one vertex twice, which then is the point
 * @param share two polynomials, positive at the time: the point is (share[0] first end + share[1]
 * second end) / (share[0] + share[1]); not used for a vertex */
void star_find(star *out, placing *p, pair_side side, const uint32_t edge[2],
               const fmpz_poly_struct share[2]);

#endif
