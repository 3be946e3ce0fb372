/* A typed table as a VTK file.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TABLE_TYPED_VTK_H
#define GRAZE_TABLE_TYPED_VTK_H

#include "output/table/typed.h"

/** As a legacy VTK file: a grid as structured points, else vertices. */
graze_status typed_write_vtk(const typed_table *t, sink to);

#endif
