/* The readers of solids, one a format; soup_read chooses among them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Each takes a whole file's bytes and fills an initialised soup of the format's dimension. What it
 * leaves in the soup on failure is the caller's to clear. A message names path and line, or path
 * and byte in a binary file.
 */
#ifndef GRAZE_SOLID_READERS_H
#define GRAZE_SOLID_READERS_H

#include "solid/soup.h"

typedef graze_status soup_reader(soup *s, graze_context *context, const char *path,
                                 const char *text, size_t length);

soup_reader read_off;
soup_reader read_obj;
soup_reader read_ply;
soup_reader read_stl;
soup_reader read_nef3;
soup_reader read_wkt;

#endif
