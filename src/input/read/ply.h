/* The reader of .ply files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_READ_PLY_H
#define GRAZE_READ_PLY_H

#include "input/read/reader.h"

/** PLY, a polygon mesh, ASCII or binary. */
soup_reader read_ply;

#endif
