/* Maps of OpenSCAD's nodes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SCAD_MAP_H
#define GRAZE_SCAD_MAP_H

#include "input/scad/writer.h"

/** A map: its linear part, 9 in rows, and its shift; of a node of the plane those of x and y. */
typedef struct scad_map {
    fmpq *linear, *shift;
    fmpq_t error; /* at least the norm of what a rotation that is taken changes */
} scad_map;

void scad_map_init(scad_map *m);
void scad_map_clear(scad_map *m);

/** Read a multmatrix.
 * @param[out] turned whether a rotation is taken instead of its linear part */
graze_status scad_map_read(scad_map *out, scad_writer *w, const scad_place *p, int *turned);

/** Compose the map at hand, of what is revolved, with another one, which acts first. */
void scad_compose(scad_writer *w, const scad_map *m);

/** Let `reach` and `moved` be those of the image of the last node. */
void scad_map_bounds(scad_writer *w, const scad_map *m);

#endif
