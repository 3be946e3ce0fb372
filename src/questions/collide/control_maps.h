/* The motion during an interval of one piece, as affine maps in doubles between which it stays.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_CONTROL_MAPS_H
#define GRAZE_COLLIDE_CONTROL_MAPS_H

#include "base/number/bernstein.h"
#include "input/motion/motion.h"
#include "input/solid/tree.h"

/** At each time of the interval a point x is at a convex combination of its images under the maps,
 * with one set of weights for all points (proofs/collision.md C108). Each entry differs from the
 * exact one by at most 2^-48 of its size, or 2^-900. */
typedef struct control_maps {
    int dimension;
    size_t count;  /* 0: none are known, and the motion may carry points anywhere */
    double *entry; /* dimension * (dimension + 1) of each */
    double *room;  /* for nine numbers of each */
    double shift;  /* the greatest size of a last entry of a row, */
    double slope;  /* and the greatest sum of sizes of the others */
} control_maps;

/** Bernstein coefficients of a point map on an interval: entries, then the weight, of one degree.
 */
typedef struct map_forms {
    int dimension;
    slong degree;
    bernstein_form form[POINT_MAP_ENTRIES + 1];
} map_forms;

void map_forms_init(map_forms *out, const point_map *map, const dyadic_interval *interval);
void map_forms_clear(map_forms *forms);
/** The forms become those of the left half; `right` is new. */
void map_forms_split(map_forms *forms, map_forms *right);

/** Zeros before the first use; control_maps_clear frees. @return 0 without memory */
int control_maps_set(control_maps *out, const map_forms *forms);
/** control_maps_set for one affine map, that of one time. */
int control_maps_set_one(control_maps *out, const fmpq *map, int dimension);
void control_maps_clear(control_maps *maps);

/** A box around the images of a box during the interval; all of space where no maps are known. */
void control_maps_bound(box *out, const control_maps *maps, const box *of);

#endif
