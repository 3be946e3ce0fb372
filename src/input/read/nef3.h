/* The reader of .nef3 files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_READ_NEF3_H
#define GRAZE_READ_NEF3_H

#include "input/read/reader.h"

/** A selective Nef complex of CGAL: GRAZE_EILLEGAL unless it is bounded and regular closed. */
soup_reader read_nef3;

#endif
