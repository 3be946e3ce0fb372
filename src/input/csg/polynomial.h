/* Polynomials and polygons of curved solids. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_CSG_POLYNOMIAL_H
#define GRAZE_CSG_POLYNOMIAL_H

#include "input/csg/csg_reader.h"

/* Each is a csg_primitive_reader. */
graze_status csg_read_polynomial(size_t *node, csg_reader *r, const json *value);
graze_status csg_read_polygon(size_t *node, csg_reader *r, const json *value);

#endif
