/* The rims of patches: where the surface leaves a cell.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_BOUNDARY_RIM_H
#define GRAZE_BOUNDARY_RIM_H

#include "questions/boundary/sampling.h"

/* A patch has at most two faces a simplex. */
enum { RIM_MOST = 36 };

/** Vertices in the order of the faces' sides: a closed polygon on the sides of the cell; in E^2 the
 * way from one side to another. */
typedef struct rim {
    size_t count, vertex[RIM_MOST];
} rim;

/** A run of edges of a rim that lies in one side of the cell. */
typedef struct rim_run {
    size_t first, edges; /* from vertex `first` on */
} rim_run;

/** 1 if the patch has one rim, which passes each of its vertices once. */
int rim_find(rim *out, const struct graze_boundary *b, size_t patch);

/** 1 if just one run of a closed rim lies in the lower or upper side of its cell along an axis. */
int rim_run_at(rim_run *out, const struct graze_boundary *b, const sample_cell *c,
               const size_t *vertex, size_t count, int axis, int upper);

#endif
