/* read: reads an `.off`, `.obj`, `.ply`, `.stl`, `.nef3` or `.wkt` file into a soup.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_READ_H
#define GRAZE_INPUT_READ_H

#include "input/soup/soup.h"

/* Polygons from rings of a plane: their nesting decides which are outer rings and holes. */

/**
 * Append rings to a soup as polygons: a ring inside an even number of others is an outer one
 * and is turned counter-clockwise, the others are holes of the innermost ring around them and are
 * turned clockwise. Rings that cross are placed anyhow; validation refuses them.
 * @param size  ring_count sizes, each at least 3
 * @param index the vertices of all rings, in range of the soup's vertices
 * @param axis  the two coordinates in which the rings are seen; 0 and 1 in E^2
 * @return GRAZE_EILLEGAL a ring has area zero; the message calls the ring a facet; GRAZE_ELIMIT;
 * GRAZE_ESYSTEM
 */
graze_status nesting_add_rings(soup *s, graze_context *context, const size_t *size,
                               size_t ring_count, const size_t *index, const int axis[2]);

/* Reading of solids from files. */

/** Takes a whole file's bytes and fills an initialised soup of the format's dimension. On failure
 * the caller clears the soup. A message names path and line, or path and byte in a binary file. */
typedef graze_status soup_reader(soup *s, graze_context *context, const char *path,
                                 const char *text, size_t length);

/** A file of facets or rings; OpenSCAD's .csg; .csg.json; a file that is not read. */
typedef enum format_kind { FORMAT_SOUP, FORMAT_SCAD, FORMAT_CURVED, FORMAT_NONE } format_kind;

/** A format of solids, or of other files that users take for solids. */
typedef struct solid_format {
    const char *ending; /* of the file's name, in any case */
    format_kind kind;
    int dimension;      /* of a soup; else 0 */
    soup_reader *read;  /* of a soup */
    const char *advice; /* FORMAT_NONE: how to get a format that is read; else why this one is not
                           mended; NULL for a mesh */
} solid_format;

/** The format by the ending of the file's name; one of kind FORMAT_NONE if it is not read. */
const solid_format *format_of(const char *path);

/**
 * Read a soup in the format that the file's name says. Numbers are exact, then rounded as the
 * context says. Sets s->sha256.
 * @param[out] s uninitialised; on failure nothing is left to clear
 * @return GRAZE_ESYSTEM the file cannot be read; GRAZE_EINPUT the file is malformed or of no soup's
 * format; GRAZE_EILLEGAL no facets, or a .nef3 that is unbounded or not regular closed;
 * GRAZE_ELIMIT
 */
graze_status soup_read(soup *s, graze_context *context, const char *path);

/** As soup_read; the file may have no facets. */
graze_status soup_read_any(soup *s, graze_context *context, const char *path);

/** As soup_read; GRAZE_EINPUT for formats other than .off, .obj, .ply and .stl, which can be
 * mended. */
graze_status soup_read_mesh(soup *s, graze_context *context, const char *path);

#endif
