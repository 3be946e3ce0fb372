/* The reader of .wkt files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_READ_WKT_H
#define GRAZE_READ_WKT_H

#include "input/read/reader.h"

/** POLYGON and MULTIPOLYGON of E^2. */
soup_reader read_wkt;

#endif
