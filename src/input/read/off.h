/* The reader of .off files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_READ_OFF_H
#define GRAZE_READ_OFF_H

#include "input/read/reader.h"

/** OFF, a polygon mesh. */
soup_reader read_off;

#endif
