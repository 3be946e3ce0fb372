/* Solids of OpenSCAD's `.csg` files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_API_API_SCAD_H
#define GRAZE_API_API_SCAD_H

#include "graze/core.h"

/** Read a file and take everything as it stands. `sha256` is that of a file read before, or
 * NULL. */
graze_status api_scad_solid(graze_solid **out, graze_context *context, const char *path,
                            const unsigned char *sha256);

#endif
