/* topo: decides where a point lies relative to the closed sweep, level by level, and gives a
 * witness for a point of its boundary.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_TOPO_H
#define GRAZE_QUESTIONS_TOPO_H

#include "base/number/algebraic.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "graze/topo.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"

/* The result about a point's position relative to the closed sweep. */

/** Kinds of witnesses that P is on the boundary: a point that is out, on a ray from P, on the path
 * P + s^order open + s^(order + 1) lift across, or on the border of a square about P. */
typedef enum topo_witness { WITNESS_RAY, WITNESS_PATH, WITNESS_SQUARE } topo_witness;

/** A result. `reason` is "" unless the point is undecided; `witness`, `reach`, `direction` and
 * `along` are set only if `has_witness`, `open` only if `has_open`. */
typedef struct topo_finding {
    graze_topo position;
    graze_topo_level level;
    const char *reason; /* static */
    int has_witness;
    fmpq witness[3]; /* a point that is `out` */
    fmpq reach;      /* for a ray or path: the witness's parameter; all points with smaller positive
                        parameters are `out` too */
    fmpz direction[3]; /* of the ray */
    fmpz along[2][3];  /* for a square: its sides run along these two vectors, and half a side is
                          `reach` times the vector */
    int has_open;
    fmpz open[3];   /* unless `has_across`: a direction that no contact covers to first order */
    int has_across; /* 1: all directions without a covered neighbourhood lie in the plane with the
                       normal `across`, and `open` is one that leading terms do not cover */
    fmpz across[3];
    slong order; /* of a path along `open` between the contacts; 0: none is known */
    fmpq lift;
} topo_finding;

/** Begin without a result. */
void finding_init(topo_finding *f);
void finding_clear(topo_finding *f);
topo_witness finding_witness(const topo_finding *f);

/* The position of a point relative to the closed sweep, by the cheapest level that decides it
 * (proofs/topology.md C45 for the word; each other level cites its claim). */

/** Decide the position of a point.
 * @param[out] out initialised
 * @param trace the point's trace, decided
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL */
graze_status topo_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                         const fmpq *point, const graze_trace *trace);

/** Decide the position relative to the regularised unsweep, the closure of the unsweep's interior,
 * as topo_decide does. An `on` point outside this closure belongs to a dangling part
 * (proofs/dangling.md C113). */
graze_status topo_regular(topo_finding *out, graze_context *context, const graze_scene *scene,
                          const fmpq *point, const graze_trace *trace);

/* The local cone of a solid at a boundary point: the states of the directions there.
 *
 * Vectors are d integers, up to a positive factor. */

/** A cone. `normal` has the normals, outward or inward, of the `count` distinct planes of the
 * facets that contain the point. The state of a direction depends only on its signs against these
 * planes (proofs/claims.md C1), so states are kept by signs. */
typedef struct local_cone {
    const graze_solid *solid;
    int outside;              /* 1: the cone of the closure of the solid's complement */
    const plane_list *planes; /* of all facets */
    int dimension;
    fmpz *at;      /* the point: d + 1 homogeneous integers, the last one positive */
    slong nearest; /* a step of 2^-(nearest + b) / (last coordinate) times a direction with entries
                      of b bits reaches no plane that misses the point */
    size_t count;
    fmpz *normal; /* d integers each */
    size_t known, known_capacity;
    signed char *known_item; /* for each kept answer the signs, then the state */
    int knows_all;           /* the states of all cells of the arrangement are kept */
} local_cone;

/** Make the cone at a point. The caller calls cone_clear in any case; it takes zeros too.
 * @param outside 1: make the cone of the closure of the solid's complement: I and O are exchanged
 */
graze_status cone_make(local_cone *cone, graze_context *context, const graze_solid *solid,
                       int outside, const plane_list *planes, const fmpz *at);
void cone_clear(local_cone *cone);

/** The state of the points near the cone's point in a direction from it. */
graze_status cone_state(graze_state *out, local_cone *cone, graze_context *context,
                        const fmpz *direction);

/** The dimension of the boundary cell at the point: of the intersection of the cone's planes. */
int cone_cell_dimension(const local_cone *cone);

/** Is one of the directions u + s e, s >= 0, in the cone's interior, and is one in the cone?
 * @param ray if not NULL: ask the cone's own local cone at this direction instead */
graze_status cone_sweep(int *in_interior, int *in_cone, local_cone *cone, graze_context *context,
                        const fmpz *ray, const fmpz *u, const fmpz *e);

/* Germs: a trajectory's contacts with the solid to first order. */

/** One side of a contact: the times just before or just after it, in which the trajectory leaves
 * the boundary cell of the contact (proofs/topology.md C46, C51, C52). */
typedef struct germ_side {
    int sign;  /* 1 after the contact, -1 before it */
    fmpz e[3]; /* the trajectory's leading direction, modulo directions along the cell */
    slong order;
    int exact;     /* the cover by this side is exactly the closed cone swept along e */
    int has_later; /* e runs along an edge that leaves the vertex, and `later` leaves the edge */
    fmpz later[3];
    int edge_way;   /* the opposite of e is covered with a neighbourhood */
    int keeps_edge; /* d = 3: the cover does not depend on the motion along the cell, an edge */
} germ_side;

/** Data of a germ at an irrational time: the time, and the trajectory's distances from the cone's
 * planes as functions of time, differentiated up to the order of the sides. */
typedef struct germ_root {
    algebraic time;
    size_t count;
    fmpz_poly_struct way[];
} germ_root;

/** A time of contact: the local cone at the trajectory's place, and the linear map from directions
 * about P to directions of the body. */
typedef struct germ {
    local_cone cone;
    const point_map *map; /* of the piece */
    int has_time;
    fmpq time; /* the piece's parameter, if it is rational */
    fmpz to_body[9];
    germ_root *root; /* NULL if all other members are exact; else they are approximate and prove no
                        cover */
    int exact;       /* the planes of the cone keep their directions on the piece */
    int side_count;
    germ_side side[2];
    int covers_edge; /* d = 3: both directions of the cell, an edge, have covered neighbourhoods */
} germ;

/** Parts of a germ: all of it; the solid at the time itself; the number of a side stands for the
 * solid at the time and that side. */
enum { GERM_WHOLE = -2, GERM_REST = -1 };

/** An interval of time in which the solid turns and the trajectory remains in one boundary cell. */
typedef struct turning_stretch {
    size_t germ; /* index of a germ at a time inside the stretch */
    algebraic from, to;
} turning_stretch;

/** All germs of a point P. `bounded`: the germs and turning stretches cover every tangent direction
 * of the closed sweep at P (a limit of directions from P to points of the sweep that tend to P);
 * else `reason` names what may cover more. */
typedef struct germ_list {
    size_t count, capacity;
    germ *item;
    size_t turn_count, turn_capacity;
    turning_stretch *turn;
    int bounded;
    const char *reason;
} germ_list;

void germ_list_init(germ_list *list);
void germ_list_clear(germ_list *list);

/** The planes of all facets of a scene, made at the first call and kept with the scene. */
graze_status topo_planes(const plane_list **out, graze_context *context, const graze_scene *scene);

/** Find the germs of all contacts of a point (proofs/topology.md C46); `edge_way` and `covers_edge`
 * remain 0 until edge_ways_find. */
graze_status germs_find(germ_list *list, graze_context *context, const graze_scene *scene,
                        const plane_list *planes, const fmpq *point);

/** Append the germ at a rational time u of a piece, at which the trajectory is on the boundary,
 * with its sides in that piece, as germs_find does. */
graze_status germs_at(germ_list *list, graze_context *context, const graze_scene *scene,
                      const plane_list *planes, const fmpq *point, size_t piece, const fmpq_t u);

/** Carry a direction about P to directions of the body. */
void germ_to_body(fmpz *out, const germ *g, const fmpz *direction);

/* The central arrangement of the planes (E^2: lines) at which the cover of directions can change.
 */

/** Bounds of the numbers of planes and rays of an arrangement. */
enum { BORDER_PLANES = 60, BORDER_RAYS = 3000 };

/** An arrangement. `plane`: the planes' normals, d integers each, no two parallel; they span all
 * directions. `ray`: the rays in which d - 1 planes meet, each once; the closure of every cell
 * contains at least one ray. */
typedef struct borders {
    int dimension;
    size_t plane_count, plane_capacity, ray_count, ray_capacity;
    fmpz *plane, *ray;
} borders;

void borders_init(borders *b, int dimension);
void borders_clear(borders *b);

/** Make the arrangement of the planes of all germs and of their sides, in directions about P.
 * @param[out] refused 1 if a bound is exceeded: then the arrangement is incomplete */
graze_status borders_find(borders *b, int *refused, graze_context *context, germ_list *germs);

/** A direction, d integers, in each cell around a ray, in order around the ray. In E^3 cell 2 k has
 * dimension 3, cell 2 k + 1 is the cell of dimension 2 after it. In E^2 there are the two cells of
 * dimension 2 beside the ray. */
typedef struct ray_cells {
    int dimension;
    size_t count;
    fmpz *item;
} ray_cells;

/** Make the cells around ray `r`. */
void ray_cells_init(ray_cells *out, const borders *b, size_t r);
void ray_cells_clear(ray_cells *cells);

/* Cover of directions about the point by germs. */

/** Statements about a direction. A member is 1 if its statement is proved; `covered` is 0 only if
 * it is proved that no germ covers the direction. */
typedef struct germ_cover {
    int open;     /* the direction has a neighbourhood that is covered, to first order */
    int edge_way; /* the direction has a covered neighbourhood by a trajectory's way through a pinch
                     or along an edge */
    int exact;    /* the direction lies in a closed cone that is covered */
    int covered;  /* a germ may cover the direction: it lies in a closed cone that bounds the cover
                   */
} germ_cover;

/** Find how all germs together cover a direction about the point. */
graze_status germs_cover(germ_cover *out, germ_list *list, graze_context *context,
                         const fmpz *direction);

/* A place that is out near a point whose position is undecided: a hint, not a verdict. */

/** Classify places about a point of E^3, from the nearest distance to the farthest: in a few
 * directions, and in the finding's open direction and plane.
 * @param[out] found 1 if a place is out
 * @param[out] out 3 initialised rationals: a place that is out, of the nearest distance with one
 * @param[out] places the place's distance is about the solid's width times 2^-places; if no place
 * is out, `places` stands for the farthest distance tried */
graze_status hint_find(int *found, fmpq *out, ulong *places, graze_context *context,
                       const graze_scene *scene, const fmpq *point, const topo_finding *topo);

/* Sectors of directions about a point of E^2. */

/** The germs whose cover of directions is asked for, to first order. */
typedef struct sector_question {
    germ_list *list;       /* ask about all of these together, unless: */
    germ *germ;            /* if not NULL: ask about a part of this germ alone */
    int part;              /* of `germ`: GERM_WHOLE, GERM_REST or a side */
    turning_stretch *turn; /* if not NULL: ask about this stretch alone */
    int open;              /* 1: ask for the sectors that are not covered */
} sector_question;

/** Disjoint sectors: sector k runs counter-clockwise from ray 2 k to ray 2 k + 1, each of 2
 * integers. */
typedef struct sector_list {
    int all; /* one sector of all directions, without rays */
    size_t count;
    fmpz *ray;
} sector_list;

/** Free the rays and set the list to zeros. */
void sectors_clear(sector_list *list);
/** Find the sectors of a question. Those of turning stretches are approximate: they end at borders
 * of the germs or at one of TURN_RAYS more rays. If there are too many borders, `out` stays as it
 * was. */
graze_status sectors_find(sector_list *out, graze_context *context, const sector_question *asked);

/* Orthogonal projections. */

/** The planes in which a point lies by now: `rank` forms of d + 1 rationals, their normals
 * orthogonal; `form` has room for d. */
typedef struct plane_stack {
    int dimension, rank;
    fmpq *form;
} plane_stack;

/** Project x, d coordinates and a 1, orthogonally to one more plane, within the planes before; or a
 * direction, which ends in a 0. A plane whose normal depends on theirs changes nothing. */
void plane_stack_add(plane_stack *p, fmpq *x, const fmpz *form);

/* Directions, as vectors of integers. */

/** In E^3: is one vector a multiple of the other? */
int directions_parallel(const fmpz *a, const fmpz *b);

/** Divide n integers by their greatest common divisor. */
void direction_reduce(fmpz *v, slong n);

/** Set coprime integers to n rationals times a positive number. */
void direction_of_rationals(fmpz *out, const fmpq *x, slong n);

#endif
