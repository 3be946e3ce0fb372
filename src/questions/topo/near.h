/* Germs near a point: leading terms, paths, pullbacks, roots.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_TOPO_NEAR_H
#define GRAZE_QUESTIONS_TOPO_NEAR_H

#include <flint/fmpq.h>
#include "base/number/algebraic.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "graze/topo.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "questions/topo/cover.h"
#include "questions/topo/topo.h"

void finding_set(topo_finding *f, graze_topo position, graze_topo_level level);
void finding_undecided(topo_finding *f, const char *reason);

/** Append a germ with the map of its piece; its other members are zeros. */
graze_status germs_append(germ **out, germ_list *list, graze_context *context,
                          const point_map *map);

/** Remove the last germ. */
void germs_drop_last(germ_list *list);

/** Append a turning stretch between two times; the list's last germ is at a time inside it. */
graze_status germs_append_turn(germ_list *list, graze_context *context, const algebraic *from,
                               const algebraic *to);

/** Allocate a germ's root at a time, with zeros as polynomials. */
graze_status germ_make_root(germ *g, graze_context *context, const algebraic *time);
/** Free a germ's root. */
void germ_drop_root(germ *g);

/** Clear `bounded`, as germs are missing, and keep the reason, a static text. */
void germs_leave_open(germ_list *list, const char *reason);

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

/* A direction of E^3 along which the cover by the contacts is invariant. */

/** Find a direction about the point that is parallel to all planes of all contacts' cones at all
 * times of their pieces; returns 0 if there is none. E^3 only; the list must be bounded. */
int invariant_direction(fmpz *out, const germ_list *list);

/** Find a direction parallel to all planes of all contacts' cones but the ones with the normal
 * `step`, which do not move and contain the trajectory throughout their pieces. Returns 1 if there
 * are such planes and the direction crosses them, else 0 with a zero `step` (proofs/topology.md
 * C128). */
int invariant_beside_step(fmpz *out, fmpz *step, const germ_list *list, const fmpq *point);

/* The level of leading directions: are all cells of the arrangement of borders covered? */

/** Decide the position of an `on` point of a sweep, or leave it undecided with a reason
 * (proofs/topology.md C46). */
graze_status leading_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                            const plane_list *planes, const fmpq *point);

/* The curves near a point: the coprime parts through it, and a square around it without other
 * events. */

/** Invariant (proofs/topology.md C48), with P at the origin and r = 2^-places: in the square |x|,
 * |y| <= r the curves of the list that this was made of have no zeros but those of `through`. The
 * polynomials of `through` are squarefree, pairwise coprime and vanish at the origin. For 0 < |x|
 * <= r their real roots in y are simple and distinct, their number does not depend on |x|, and none
 * is x or -x unless it is so for all x. All of this holds with x and y exchanged too. */
typedef struct near_curves {
    curve_list through;
    ulong places;
} near_curves;

/** Begin without curves, with r = 1. */
void near_curves_init(near_curves *n);
void near_curves_clear(near_curves *n);

/** Find the parts and the square for a list of curves and a point of 2 rationals.
 * @param[out] refused 1 if r needs more than `bits` places (the context's limit), or coprime_add
 * refuses */
graze_status near_make(near_curves *n, int *refused, graze_context *context, const curve_list *all,
                       const fmpq *point);

/** The product of the curves `through` on a side of the square, times a power of 2, as a polynomial
 * in the coordinate along the side. The side is on the line x = r or, with `negative`, x = -r; with
 * `axis` 1 on y = r or y = -r. */
void near_side(fmpz_poly_t out, const near_curves *n, int axis, int negative);

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
