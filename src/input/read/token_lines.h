/* Reading meshes and WKT, line by line.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_READ_TOKEN_LINES_H
#define GRAZE_INPUT_READ_TOKEN_LINES_H

#include <flint/fmpq.h>
#include "input/read/read.h"

/* A text as lines of tokens, with line numbers for messages, for the readers of solids.
 *
 * A token is a run of bytes without blanks; a byte of `marks` is a token by itself. Tokens point
 * into the text and nothing is copied. */

typedef struct token {
    const char *text;
    size_t length;
} token;

typedef struct lines {
    graze_context *context;
    const char *path;
    const char *marks; /* bytes that are tokens by themselves; "" for none */
    char comment;      /* begins a comment that ends with its line; 0 for none */
    int continued;     /* a backslash before the line's end joins the next line */
    const char *at;    /* first byte not yet read */
    const char *end;
    size_t line;              /* of `at`, from 1 */
    size_t where;             /* line of the last token read, for messages */
    unsigned char stops[256]; /* bytes that end a token, a backslash only before a line's end */
} lines;

/** Begin a text whose first five fields are set; a byte order mark is skipped. */
void lines_begin(lines *l, const char *text, size_t length);

/**
 * Begin a text, after a check of all its lines.
 * @return GRAZE_ELIMIT a line is too long; GRAZE_EINPUT a NUL byte or a lone carriage return
 */
graze_status lines_start(lines *l, const char *text, size_t length);

/** The next token of this line; 0 at the line's end, before its newline. */
int lines_token(lines *l, token *out);

/** Step over the rest of this line and over lines without tokens; 0 at the end of the text. */
int lines_next(lines *l);

/** The next token on this line or a later one; 0 at the end of the text. */
int lines_any(lines *l, token *out);

/** Fail with "path:line: " of the last token before the message, given as for printf. */
#define lines_fail(l, status, ...)                                                                 \
    context_fail_in((l)->context, status, (l)->path, (l)->where, __VA_ARGS__)

/** Put "path:line: " before the message of a failure on its way up; GRAZE_OK passes through. */
graze_status lines_at(const lines *l, graze_status status);

/** Read the next `count` tokens of this line as numbers. `what` and `index` name
 * their owner in messages. */
graze_status lines_numbers(lines *l, fmpq *out, int count, const char *what, size_t index);

/** Append a facet with one empty cycle; the caller adds its indices by soup_add_index. */
graze_status facet_begin(soup *s, graze_context *context);

/** Read a number of cells: a plain integer within the limit `cells`. `what` names the cells, in the
 * plural. */
graze_status lines_cells(lines *l, size_t *out, const char *what);

/** Whether a token is the word, in upper or lower case. */
int token_is(token t, const char *word);

/** Whether a token is an integer, with or without sign. *out is its value, cut to +-10^18. */
int token_integer(token t, long long *out);

/** For messages: `%.*s` of the token, shortened. */
#define TOKEN_SHOWN(t) ((t).length > 40 ? 40 : (int)(t).length), (t).text

/* The reader of .obj files. */

/** Wavefront OBJ, a polygon mesh. */
soup_reader read_obj;

/* The reader of .off files. */

/** OFF, a polygon mesh. */
soup_reader read_off;

/* The reader of .ply files. */

/** PLY, a polygon mesh, ASCII or binary. */
soup_reader read_ply;

/* The header of a PLY file: the elements that follow, their properties, and their form. */

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

/** The meaning of a property; values of PLY_PASSED are skipped. */
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

/* The reader of .stl files. */

/** STL, a triangle mesh, ASCII or binary. */
soup_reader read_stl;

/* The reader of .wkt files. */

/** POLYGON and MULTIPOLYGON of E^2. */
soup_reader read_wkt;

#endif
