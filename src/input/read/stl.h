/* The reader of .stl files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_READ_STL_H
#define GRAZE_READ_STL_H

#include "input/read/reader.h"

/** STL, a triangle mesh, ASCII or binary. */
soup_reader read_stl;

#endif
