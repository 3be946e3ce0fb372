/* Boundaries by sampling as files: PLY, legacy VTK, CSV.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_BOUNDARY_FILES_H
#define GRAZE_RUN_BOUNDARY_FILES_H

#include "graze.h"

/** EXIT_USAGE unless each name that is not NULL has an extension that its kind can be written in.
 */
int boundary_check_names(const char *surface, const char *cells, const char *points);
/** Refuse a surface that no file of this kind holds in the plane. */
int boundary_check_surface(const char *surface, int dimension);

/** Write a file in the form of its extension. Coordinates are the nearest binary64, in CSV exact.
 * Each returns an exit status and says what is wrong; EXIT_INPUT for a coordinate past the range of
 * binary64. */
int boundary_write_surface(const char *path, const graze_boundary *b, graze_context *context,
                           int dimension);
int boundary_write_cells(const char *path, const graze_boundary *b, graze_context *context,
                         int dimension);
int boundary_write_points(const char *path, const graze_boundary *b, graze_context *context,
                          int dimension);

#endif
