/* Convex polyhedra of curved solids. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_CSG_POLYHEDRON_H
#define GRAZE_CSG_POLYHEDRON_H

#include "input/csg/csg_reader.h"

/** A csg_primitive_reader. */
graze_status csg_read_polyhedron(size_t *node, csg_reader *r, const json *value);

#endif
