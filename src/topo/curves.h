/* The plane curves on which the boundary of a sweep lies.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_CURVES_H
#define GRAZE_TOPO_CURVES_H

#include <flint/fmpq_mpoly.h>
#include "scene/scene.h"
#include "solid/planes.h"

/** Most curves, in E^2, once for a scene, and in a plane of E^3, for each point; there also the
 * largest degree in time of a pullback whose discriminant is taken. In E^2 that is the context's
 * limit `curve`. */
enum { CURVE_COUNT = 100000, SLICE_CURVE_COUNT = 5000, SLICE_CURVE_DEGREE = 8 };

/** Variables of the ring. */
enum { RING_X, RING_Y, RING_VARIABLES };

/** Polynomials in x and y, none of them constant. */
typedef struct curve_list {
    fmpz_mpoly_ctx_t ring;
    size_t count, capacity;
    fmpz_mpoly_struct *item;
} curve_list;

void curves_init(curve_list *list);
void curves_clear(curve_list *list);

/** Append a copy of a polynomial that is not 0; one without x and y is left out. */
graze_status curves_append(curve_list *list, graze_context *context, const fmpz_mpoly_t curve);

/**
 * Coordinates of a plane: x, y stand for the point `origin` + x a + y b. In E^2 it is all of it
 * with its own coordinates, in E^3 the plane through a point along two vectors.
 */
typedef struct plane_view {
    int dimension;
    fmpq origin[3];
    fmpz along[2][3]; /* a and b */
} plane_view;

/** E^2 as it is. */
void view_init(plane_view *view);
/** The plane through a point of E^3 along two vectors of 3 integers, not parallel. */
void view_init_through(plane_view *view, const fmpq *point, const fmpz *a, const fmpz *b);
void view_clear(plane_view *view);
/** The point with two coordinates, d initialised rationals. */
void view_point(fmpq *out, const plane_view *view, const fmpq *xy);

/**
 * Append curves in the zeros of which the boundary of the closed sweep lies in the plane, up to
 * finitely many points (proofs/topology.md C47, C50): of the facets' planes the lines at the ends
 * of all pieces and the discriminants of the pullbacks, and the paths of the vertices, in E^3 of
 * the edges.
 * @param[out] refused why the list is not whole: curves that are too dear, or (E^3) a facet or an
 * edge that comes to lie in the plane; else NULL
 * @param planes       of all facets of the scene's solid
 */
graze_status curves_of_scene(curve_list *list, const char **refused, graze_context *context,
                             const graze_scene *scene, const plane_list *planes,
                             const plane_view *view);

#endif
