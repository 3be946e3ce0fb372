/* The signed distances of a mesh's vertices as a file.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_VERTEX_TABLE_H
#define GRAZE_RUN_VERTEX_TABLE_H

#include "graze.h"

/** EXIT_USAGE unless the name ends in .csv or .vtk. */
int vertex_table_check(const char *path);

/**
 * Write a row for each vertex in its order: x, y, z, pmc, sdf_low, sdf_high; or a VTK file of the
 * mesh with the same as data of its points. Returns an exit status and says what is wrong.
 * @param found one enclosure for each vertex
 */
int vertex_table_write(const char *path, graze_context *context, const graze_mesh *mesh,
                       const graze_enclosure *found);

#endif
