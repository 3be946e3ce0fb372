/* Primitives of space of OpenSCAD's files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SCAD_BODIES_H
#define GRAZE_SCAD_BODIES_H

#include "input/scad/writer.h"

/** Write a cube, a sphere, a cylinder or a polyhedron; `reach` is set. */
graze_status scad_write_body(scad_writer *w, const scad_place *p);

#endif
