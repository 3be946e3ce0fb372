/* Reading of solids from files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_READ_READ_H
#define GRAZE_READ_READ_H

#include "input/soup/soup.h"

/**
 * Read a file by its extension (.off .obj .ply .stl .nef3 .wkt, any case). Number tokens are exact
 * and rounded as the context says. Fills sha256.
 * @param[out] s uninitialised; on failure nothing is left to clear
 * @return GRAZE_ESYSTEM the file cannot be read; GRAZE_EINPUT with file and line (or byte) and what
 * is expected; GRAZE_EILLEGAL no facets, or a .nef3 that is unbounded or not regular closed;
 * GRAZE_ELIMIT
 */
graze_status soup_read(soup *s, graze_context *context, const char *path);

/** As soup_read; the file may have no facets. */
graze_status soup_read_any(soup *s, graze_context *context, const char *path);

#endif
