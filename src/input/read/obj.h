/* The reader of .obj files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_READ_OBJ_H
#define GRAZE_READ_OBJ_H

#include "input/read/reader.h"

/** Wavefront OBJ, a polygon mesh. */
soup_reader read_obj;

#endif
