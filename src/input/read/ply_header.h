/* The header of a PLY file: the elements that follow, their properties, and their form.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_READ_PLY_HEADER_H
#define GRAZE_READ_PLY_HEADER_H

#include "input/read/token_lines.h"

typedef enum ply_format { PLY_ASCII, PLY_LITTLE_ENDIAN, PLY_BIG_ENDIAN } ply_format;

/** The types of values; the integers stand before the floats. */
typedef enum ply_type {
    PLY_INT8,
    PLY_UINT8,
    PLY_INT16,
    PLY_UINT16,
    PLY_INT32,
    PLY_UINT32,
    PLY_FLOAT32,
    PLY_FLOAT64,
    PLY_TYPE_COUNT
} ply_type;

/** The meaning of a property; one that has none for Graze is passed over. */
typedef enum ply_role { PLY_X, PLY_Y, PLY_Z, PLY_INDICES, PLY_PASSED } ply_role;

typedef struct ply_property {
    token name;
    int is_list;
    ply_type count_type; /* of a list */
    ply_type type;
    ply_role role;
} ply_property;

/** Invariant: "vertex" has exactly one of each of x, y, z, none of them a list; "face" has exactly
 * one list of indices, with integers. */
typedef struct ply_element {
    token name;
    int is_vertex, is_face;
    size_t count;
    size_t first, property_count; /* of ply_header.property */
} ply_element;

typedef struct ply_header {
    ply_format format;
    ply_element *element;
    size_t element_count;
    ply_property *property;
    size_t property_count;
    size_t vertex_count;
} ply_header;

/** Read the header; `l` then stands behind "end_header". On failure nothing is left to clear. */
graze_status ply_header_read(ply_header *out, lines *l);
void ply_header_clear(ply_header *header);

#endif
