/* Coordinates in a plane, and lists of curves there. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_TOPO_PLANE_H
#define GRAZE_TOPO_PLANE_H

#include <flint/fmpq.h>
#include <flint/fmpz_mpoly.h>
#include "base/context/context.h"

/** Variables of the polynomials of curves. */
enum { RING_X, RING_Y, RING_VARIABLES };

/** Curves: polynomials in x and y, none of them constant. */
typedef struct curve_list {
    fmpz_mpoly_ctx_t ring;
    size_t count, capacity;
    fmpz_mpoly_struct *item;
} curve_list;

void curves_init(curve_list *list);
void curves_clear(curve_list *list);

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
void view_init(plane_view *view);
/** Begin with the plane through a point of E^3 along two vectors of 3 integers, not parallel. */
void view_init_through(plane_view *view, const fmpq *point, const fmpz *a, const fmpz *b);
void view_clear(plane_view *view);
/** Set the point with coordinates x, y; `out` has d initialised rationals. */
void view_point(fmpq *out, const plane_view *view, const fmpq *xy);

#endif
