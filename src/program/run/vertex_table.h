/* The signed distances of a mesh's vertices, and its answers, as files.
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

/** Write a row for each point: x, y, z and the mesh's pmc. Returns an exit status and says what is
 * wrong.
 * @param parity whether that is the mesh's rule, for the head
 * @param points 3 count rationals */
int answer_table_write(const char *path, int parity, graze_rationals points, const graze_pmc *found,
                       size_t count);

#endif
