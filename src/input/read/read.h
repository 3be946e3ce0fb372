/* read: a soup of an `.off`, `.obj`, `.ply`, `.stl`, `.nef3` or `.wkt` file.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_READ_H
#define GRAZE_INPUT_READ_H

#include "input/soup/soup.h"

/* Polygons from rings of E^2: outer rings and holes, by how the rings lie in one another. */

/**
 * Append rings to a soup of E^2 as polygons: a ring inside an even number of others is an outer one
 * and is turned counter-clockwise, the others are holes of the innermost ring around them and are
 * turned clockwise. Rings that cross get some place; validation refuses them.
 * @param size  ring_count sizes, each at least 3
 * @param index the vertices of all rings, in range of the soup's vertices
 * @return GRAZE_EILLEGAL a ring has area zero, named as facet; GRAZE_ELIMIT; GRAZE_ESYSTEM
 */
graze_status nesting_add_rings(soup *s, graze_context *context, const size_t *size,
                               size_t ring_count, const size_t *index);

/* Reading of solids from files. */

/** Takes a whole file's bytes and fills an initialised soup of the format's dimension. On failure
 * the caller clears the soup. A message names path and line, or path and byte in a binary file. */
typedef graze_status soup_reader(soup *s, graze_context *context, const char *path,
                                 const char *text, size_t length);

/** Facets or rings; OpenSCAD's .csg; .csg.json; no solid that is read. */
typedef enum format_kind { FORMAT_SOUP, FORMAT_SCAD, FORMAT_CURVED, FORMAT_NONE } format_kind;

/** A format of solids, or of files that are taken for one. */
typedef struct solid_format {
    const char *ending; /* of the file's name, in any case */
    format_kind kind;
    int dimension;      /* of a soup; others say it */
    soup_reader *read;  /* of a soup */
    const char *advice; /* FORMAT_NONE: where a solid comes from; else why it is not mended, NULL
                           for a mesh, which is */
} solid_format;

/** The format by the file's name; FORMAT_NONE if there is none. */
const solid_format *format_of(const char *path);

/**
 * Read a soup by the format. Number tokens are exact, and rounded as the context says. Fills
 * sha256.
 * @param[out] s uninitialised; on failure nothing is left to clear
 * @return GRAZE_ESYSTEM the file cannot be read; GRAZE_EINPUT with file and line (or byte) and what
 * is expected; GRAZE_EILLEGAL no facets, or a .nef3 that is unbounded or not regular closed;
 * GRAZE_ELIMIT
 */
graze_status soup_read(soup *s, graze_context *context, const char *path);

/** As soup_read; the file may have no facets. */
graze_status soup_read_any(soup *s, graze_context *context, const char *path);

/** As soup_read, of a mesh that may be mended. */
graze_status soup_read_mesh(soup *s, graze_context *context, const char *path);

#endif
