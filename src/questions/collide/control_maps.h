/* The motion during an interval of one piece, enclosed by the convex hull of affine maps in
 * doubles. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_CONTROL_MAPS_H
#define GRAZE_COLLIDE_CONTROL_MAPS_H

#include "base/number/bernstein.h"
#include "input/motion/motion.h"
#include "input/solid/tree.h"

/** At each time of the interval the motion is a convex combination of the maps (proofs/collision.md
 * C108). Each entry differs from the exact one by at most 2^-48 of its size, or 2^-900. */
typedef struct control_maps {
    int dimension;
    size_t count;  /* 0: no maps are known, and points may be anywhere */
    double *entry; /* dimension * (dimension + 1) for each map */
    double *room;  /* scratch memory: nine numbers for each map */
    double shift;  /* bound of the absolute values of the last entries of rows, */
    double slope;  /* and of the sums of those of the other entries of a row */
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
/** Set the one affine map of an instant, as control_maps_set does. */
int control_maps_set_one(control_maps *out, const fmpq *map, int dimension);
void control_maps_clear(control_maps *maps);

/** A box around all images of a box during the interval; all of space if no maps are known. */
void control_maps_bound(box *out, const control_maps *maps, const box *of);

#endif
