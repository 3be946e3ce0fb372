/* Primitives of curved solids. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_CSG_PRIMITIVES_H
#define GRAZE_CSG_PRIMITIVES_H

#include "input/csg/csg_reader.h"

/* Each is a csg_primitive_reader. */
graze_status csg_read_halfspace(size_t *node, csg_reader *r, const json *value);
graze_status csg_read_box(size_t *node, csg_reader *r, const json *value);
graze_status csg_read_ball(size_t *node, csg_reader *r, const json *value);
graze_status csg_read_ellipsoid(size_t *node, csg_reader *r, const json *value);
graze_status csg_read_cylinder(size_t *node, csg_reader *r, const json *value);
graze_status csg_read_cone(size_t *node, csg_reader *r, const json *value);
graze_status csg_read_torus(size_t *node, csg_reader *r, const json *value);
graze_status csg_read_capsule(size_t *node, csg_reader *r, const json *value);

#endif
