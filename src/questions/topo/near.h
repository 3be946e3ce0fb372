/* Germs near a point: leading terms, paths, pullbacks, roots.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_TOPO_NEAR_H
#define GRAZE_QUESTIONS_TOPO_NEAR_H

#include "questions/topo/cover.h"

void finding_set(topo_finding *f, graze_topo position, graze_topo_level level);
void finding_undecided(topo_finding *f, const char *reason);

/** Free a germ's root. */
void germ_drop_root(germ *g);

/* How a germ covers the direction opposite to a leading direction, and the two directions along an
 * edge. */

/** Set `edge_way` of a germ's sides and `covers_edge` (proofs/topology.md C52). */
graze_status edge_ways_find(germ *g, graze_context *context);

/** The span of directions of E^3; rank 3 is all of space. `basis`: two of the directions and, once
 * these span a plane, their cross product. */
typedef struct direction_span {
    int rank;
    fmpz *basis; /* 9 integers */
} direction_span;

void direction_span_add(direction_span *s, const fmpz *v);

/* The level of leading directions: are all cells of the arrangement of borders covered? */

/** Decide the position of an `on` point of a sweep, or leave it undecided with a reason
 * (proofs/topology.md C46). */
graze_status leading_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                            const plane_list *planes, const fmpq *point);

/* A ray from an `on` point, whose other points are out up to some distance. */

/** Find a reach of a ray from an `on` point P of a sweep (proofs/closure.md C74): if P + s
 * direction is `out` for all small s > 0, it is `out` for 0 < s <= reach.
 * @param[out] found 0 if the ray meets facets in a special position, or the reach needs more
 * halvings than the limit `bits`; another direction can be tried
 * @param[out] reach positive, if found
 * @param direction d integers, not all 0 */
graze_status ray_find_reach(int *found, fmpq_t reach, graze_context *context,
                            const graze_scene *scene, const fmpq *point, const fmpz *direction);

/* Rational points with the same signs as a trajectory's place at an irrational time. */

/** The solid, the map and the trajectory for which germs are made. */
typedef struct germ_place {
    graze_context *context;
    const graze_solid *solid;
    int outside; /* 1: the complement is swept (cone_make) */
    const plane_list *planes;
    const point_map *map; /* of the piece */
    trajectory *path;
} germ_place;

/** Find a rational point that has the same signs against all planes of facets as the trajectory's
 * place at `time`.
 * @param[out] found 0 if no attempt succeeds
 * @param[out] x d + 1 homogeneous integers, the last one positive
 * @param[out] near a rational time near `time` */
graze_status place_find(int *found, fmpz *x, fmpq_t near, const germ_place *place, algebraic *time);

/* Contacts that cover the directions of a plane from both sides, by terms of second order. */

/** Does every direction of the plane across `normal` have a neighbourhood that the germs of the
 * point, in E^3, cover? Leading terms of the germs below and above the plane decide it
 * (proofs/topology.md C55). 0: not proved.
 * @param[out] gap initialised; set if these terms are seen to leave a gap */
graze_status second_covers(int *out, plane_gap *gap, germ_list *list, graze_context *context,
                           const fmpq *point, const fmpz *normal);

/** Decide an `on` point of a sweep in E^2 by curves alone. */
graze_status topo_by_curves(topo_finding *out, graze_context *context, const graze_scene *scene,
                            const fmpq *point);

#endif
