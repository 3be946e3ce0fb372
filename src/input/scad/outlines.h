/* Primitives of the plane of OpenSCAD's files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SCAD_OUTLINES_H
#define GRAZE_SCAD_OUTLINES_H

#include "input/scad/writer.h"

/** Write a square, a circle or a polygon in the form at hand; `reach` is set. */
graze_status scad_write_outline(scad_writer *w, const scad_place *p);

/** Ends of an interval that holds its first coordinates, after the map at hand. */
graze_status scad_outline_extent(fmpq *low_high, scad_writer *w, const scad_place *p);

#endif
