/* Directions that the germs of the sweep cover.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_TOPO_COVER_H
#define GRAZE_QUESTIONS_TOPO_COVER_H

#include <flint/fmpq_poly.h>
#include <flint/fmpz_mpoly.h>
#include "questions/topo/topo.h"

/** Return 1 and set the state of the directions with these signs against the planes, if that state
 * is kept; else return 0. */
int cone_knows(graze_state *out, const local_cone *cone, const signed char *signs);

/** Is one of the directions u + s e, for any s, in the cone's interior? */
graze_status cone_meets_line(int *out, local_cone *cone, graze_context *context, const fmpz *u,
                             const fmpz *e);

/** Make the arrangement of those planes of one germ that contain a direction, in directions of the
 * body (E^3). It shows where the germ's cover changes around the direction, which is ray 0. */
graze_status borders_about(borders *b, graze_context *context, germ *g, const fmpz *direction);

/** Make the arrangement of a cone's own planes. */
graze_status borders_of_cone(borders *b, int *refused, graze_context *context,
                             const local_cone *cone);

/* Coordinates in a plane, and lists of curves there. */

/** Variables of the polynomials of curves. */
enum { RING_X, RING_Y, RING_VARIABLES };

/** Curves: polynomials in x and y, none of them constant. */
typedef struct curve_list {
    fmpz_mpoly_ctx_t ring;
    size_t count, capacity;
    fmpz_mpoly_struct *item;
} curve_list;

void curve_list_init(curve_list *list);
void curve_list_clear(curve_list *list);

/** Append a copy of a polynomial that is not 0; constants are left out. */
graze_status curves_append(curve_list *list, graze_context *context, const fmpz_mpoly_t curve);

/** Coordinates of a plane: x, y stand for the point `origin` + x a + y b. E^2 has its own
 * coordinates; in E^3 the plane passes through a point along two vectors. */
typedef struct plane_view {
    int dimension;
    fmpq origin[3];
    fmpz along[2][3]; /* a and b */
} plane_view;

/** Begin with E^2 and its own coordinates. */
void plane_view_init(plane_view *view);
/** Begin with the plane through a point of E^3 along two vectors of 3 integers, not parallel. */
void view_set_through(plane_view *view, const fmpq *point, const fmpz *a, const fmpz *b);
void plane_view_clear(plane_view *view);
/** Set the point with coordinates x, y; `out` has d initialised rationals. */
void view_point(fmpq *out, const plane_view *view, const fmpq *xy);

/* Cover of directions about the point by germs. */

/** Add the cover of a direction u of the body by one germ: by the solid at the time and by all
 * sides or, if `keeping_edge`, only the sides that keep the edge. */
graze_status germ_cover_body(germ_cover *out, germ *g, graze_context *context, const fmpz *u,
                             int keeping_edge);

/** Add the cover of a direction about the point by a part of a germ. */
graze_status germ_cover_part(germ_cover *out, germ *g, graze_context *context,
                             const fmpz *direction, int part);

/** Carry a normal of the body to a normal about the point; `out` is not the normal. */
void germ_normal_about(fmpz *out, const germ *g, const fmpz *normal);

/** In E^3: find h and k that span the vectors perpendicular to v, which is not 0. */
void directions_basis(fmpz *h, fmpz *k, const fmpz *v);

/* Affine functions of a plane's coordinates whose coefficients are polynomials in time. */

/** The function linear[0] x + linear[1] y + linear[2]; its coefficients are polynomials in time, of
 * the degree that pullback_reduce sets or less. */
typedef struct pullback_form {
    fmpz_poly_struct linear[3];
    slong degree;
} pullback_form;

void pullback_form_init(pullback_form *f);
void pullback_form_clear(pullback_form *f);

/** Compose a form on the body's space with a map at all times, restricted to the view, times an
 * integer. */
void pullback_of_form(pullback_form *f, const point_map *map, const fmpz *form,
                      const plane_view *view);

/** Divide by the coefficients' common factor, set `common` to it, and set the remaining degree in
 * time. */
void pullback_reduce(pullback_form *f, fmpz_poly_t common);

/** Evaluate at one time: the result is a line or a constant. */
void pullback_at(fmpz_mpoly_t out, const pullback_form *f, const fmpz_t time,
                 const fmpz_mpoly_ctx_t ring);

/* Discriminants and resultants in time. */

/** The discriminant with respect to time of a function of degree >= 2 in time, as a polynomial in x
 * and y. */
graze_status grid_discriminant(fmpz_mpoly_t out, graze_context *context, const pullback_form *f,
                               const fmpz_mpoly_ctx_t ring);

/** The resultant with respect to time of two functions of degrees >= 1 in time. */
graze_status grid_resultant(fmpz_mpoly_t out, graze_context *context, const pullback_form *f,
                            const pullback_form *g, const fmpz_mpoly_ctx_t ring);

/* The part of a germ on one side of a plane, as a form on the plane's directions. */

/** The half of a germ below or above the plane. Write a place near the point as x + z N, with x in
 * the plane. The germ covers z < Q(x)^(1/m), with `above` z > Q(x)^(1/m), up to terms smaller than
 * this leading one. Q is a form of degree m + 1; the root has the sign of Q (proofs/topology.md
 * C55, proofs/gaps.md C89). The statement is valid at the x where the linear form `reach` is
 * positive and the linear form `turn` is not negative, where these are given. */
typedef struct half_germ {
    int above;
    slong order;      /* m */
    fmpq_poly_t form; /* Q(h + b k) as a polynomial in b */
    int has_reach, has_turn;
    fmpq_poly_t reach, turn;
} half_germ;

/** out = v |v|^(n - 1). */
void signed_power(fmpq_t out, const fmpq_t v, slong n);

/* The halves of a germ below and above a plane through the point, by leading terms. */

/** The plane across a normal through a point, with a basis h, k. */
typedef struct open_plane {
    const fmpq *point;
    const fmpz *normal;
    fmpz *basis[2];
} open_plane;

/** Ways in which a germ may cover one side of the plane: way 0 by times on both sides of the
 * contact, way 1 + 2 s + part by times on side s of it alone (germ.side). Part 1 is used only for
 * an edge met in even order, whose form has two parts. */
enum { HALF_WAYS = 5 };

/** Find how a germ covers places below the plane (sign -1) or above it (sign 1).
 * @param[out] found 0 if this way proves no cover
 * @param[out] out   initialised */
graze_status half_of_germ(int *found, half_germ *out, const open_plane *h, graze_context *context,
                          germ *g, int sign, int way);

/* A gap along a plane between the germs below and above it, thinner than every cone: a cusp. */

/** A curve into the gap, if `order` is not 0: by leading terms no germ covers the places P +
 * s^order along + s^(order + 1) lift N for small s > 0, where N is the plane's normal. */
typedef struct plane_gap {
    fmpz along[3];
    slong order;
    fmpq lift;
} plane_gap;

void plane_gap_init(plane_gap *gap);
void plane_gap_clear(plane_gap *gap);

/* Plane curves in coordinates about a point. */

/** out = the curve at (x + P_x, y + P_y), primitive, for a point of 2 rationals; `curve` is not 0.
 */
graze_status shift_curve(fmpz_mpoly_t out, graze_context *context, const fmpz_mpoly_t curve,
                         const fmpq *point, const fmpz_mpoly_ctx_t ring);

/* The sides of a contact: the trajectory's leading directions, and whether the cover is exact. */

/** Do the planes of the cone keep their directions about P throughout a piece (proofs/topology.md
 * C51)?
 * @param[out] same_way 1 if moreover the trajectory's distances from them, each divided by the
 * factor of its plane's normal, are multiples of one function of time */
int planes_keep_directions(int *same_way, const local_cone *cone, const point_map *map,
                           const trajectory *path);

/** Set the trajectory's distance from plane j of the cone, times a positive function of time. */
void distance_from_plane(fmpz_poly_t out, const local_cone *cone, size_t j, const trajectory *path);

/** Does a germ's cell, an edge of E^3, keep its direction about P throughout a piece? */
int edge_keeps_direction(const germ *g, const point_map *map);

/** Add the side after (sign 1) or before (sign -1) a germ's rational time, if the trajectory leaves
 * the cell there.
 * @param way the trajectory's displacement from its place at that time, times a positive function,
 * in powers of the time since then */
graze_status sides_add(germ *g, graze_context *context, const point_map *map, fmpq_poly_struct *way,
                       int same_way, int sign);

/* Directions given only by their signs against a cone's planes, which are signs of polynomials at
 * a real algebraic number. */

/** A normal pulled back to directions about the point: d functions of time. */
void signs_pull_back_normal(fmpz_poly_struct *out, const point_map *map, const fmpz *normal);

/** The scalar product of a pulled back normal with a direction about the point, as a function of
 * time, times a positive one. */
void signs_pull_back(fmpz_poly_t out, const point_map *map, const fmpz *normal,
                     const fmpz *direction);

/** The state of the directions with given signs, one for each plane, which some direction must
 * have. The state is B if the cone has too many cells. */
graze_status signs_state(graze_state *out, local_cone *cone, graze_context *context,
                         const signed char *signs);

/** Set *covered to 1 if a part of a germ with a root may cover a direction about the point
 * (proofs/topology.md C53). */
graze_status signs_cover_at_root(int *covered, germ *g, graze_context *context,
                                 const fmpz *direction, int part);

/** Set *covered to 1 if the solid lies in a direction at some time inside a turning stretch; g is
 * its germ. */
graze_status signs_cover_in_turn(int *covered, turning_stretch *t, germ *g, graze_context *context,
                                 const fmpz *direction);

/* A point is decided by the curves near it: the border of a small square about it is sampled
 * between them. In E^2 this level is tried last. */

/** Sample a square about a point of the closed sweep, in a plane (proofs/topology.md C49, C50). The
 * point is on the boundary if a sample is out; else it is in the interior, if the plane decides
 * that.
 * @param level the level that the finding gets; without a sample that is out, a plane of E^3 leaves
 * the finding unchanged unless this is GRAZE_LEVEL_SECTION
 * @param curves all curves of the scene in the view
 * @param point the point's 2 coordinates in the view */
graze_status square_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                           const curve_list *curves, const plane_view *view, const fmpq *point,
                           graze_topo_level level);

#endif
