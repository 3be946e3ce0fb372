/* motion: a checked motion, as point maps both ways, of a motion file's JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_MOTION_H
#define GRAZE_INPUT_MOTION_H

#include <flint/fmpq.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_q.h>
#include "base/context/context.h"
#include "base/number/json.h"
#include "base/number/text.h"

/* Checked motions: continuous, piecewise rational, invertible on all of [t0, t1].
 *
 * On piece k the motion's parameter is t = lo + (hi - lo) u with u in [0, 1]. Both the motion and
 * its inverse are kept as point maps P -> N(u) (P, 1) / W(u) with integer polynomials in u
 * (proofs/claims.md C9). */

/** dimension * (dimension + 1), at most. */
enum { POINT_MAP_ENTRIES = 12 };

/**
 * A point map with polynomial entries: image i of a point is (sum_j entry[i*(d+1)+j] P_j +
 * entry[i*(d+1)+d]) / weight. Invariant: weight > 0 on all of [0, 1]; the entries and the weight
 * have no common factor in Z[u].
 */
typedef struct point_map {
    int dimension;
    fmpz_poly_struct entry[POINT_MAP_ENTRIES]; /* dimension*(dimension+1) in use, row by row */
    fmpz_poly_t weight;
} point_map;

typedef struct motion_piece {
    fmpq_t lo, hi;     /* in the motion's parameter t; lo < hi */
    unsigned long row; /* the line of the log that it comes from; 0: none is given */
    point_map forward; /* M(t) */
    point_map inverse; /* M(t)^-1 */
} motion_piece;

struct graze_motion {
    int dimension;
    size_t piece_count; /* at least 1; hi of one piece is lo of the next, and M agrees there */
    motion_piece *piece;
    int has_rows;             /* a piece has a row */
    unsigned char sha256[32]; /* of the file's or text's bytes */
};

/** The map that carries query points: M(t)^-1 for the sweep, M(t) for the unsweep. */
const point_map *motion_tracing(const motion_piece *piece, graze_operation operation);
/** The inverse of that map, which carries the standing solid's points to the query points' space.
 */
const point_map *motion_placing(const motion_piece *piece, graze_operation operation);

void point_map_init(point_map *map, int dimension);
void point_map_clear(point_map *map);

/** The affine map that a point map is at u: d*(d+1) rationals, initialised, row by row. */
void point_map_at(fmpq *out, const point_map *map, const fmpq_t u);

/** The sign of the determinant of an affine map as point_map_at gives it. */
int affine_orientation(const fmpq *map, int d);

void motion_destroy(graze_motion *motion);

/* A JSON text as a tree that keeps number tokens as written and knows the line of every value. */

typedef enum json_kind {
    JSON_NULL,
    JSON_BOOLEAN,
    JSON_NUMBER,
    JSON_STRING,
    JSON_ARRAY,
    JSON_OBJECT
} json_kind;

/** One value, in one block with its text and its key. Children stand in the order of the text; an
 * object's may repeat a key. */
typedef struct json {
    json_kind kind;
    size_t line; /* from 1 */
    char *text;  /* token of a number, decoded bytes of a string; a NUL follows */
    size_t length;
    char *key; /* in an object; a NUL follows, one inside is possible */
    size_t key_length;
    size_t index; /* among its parent's children */
    struct json *parent, *first, *last, *next;
    size_t count;          /* children */
    const char *source;    /* name of the file, borrowed; for messages */
    struct json *previous; /* the value read before this one; the root's is NULL */
} json;

/** A parsed text: the root, and the chain of all values by which they are freed. */
typedef struct json_document {
    json *root, *newest;
} json_document;

/**
 * Read one JSON text, UTF-8, with or without byte order mark.
 * @param[out] out  cleared by json_clear, also after a failure
 * @param source    names the text in messages; borrowed as long as the document lives
 * @return GRAZE_EINPUT with the line; GRAZE_ELIMIT nested past `depth`
 */
graze_status json_parse(json_document *out, graze_context *context, const char *source,
                        const char *text, size_t length);
void json_clear(json_document *document);

/** Fail with "source:line: path: message", where path is such as pieces[1].transform.scale[0]. */
graze_status json_fail(graze_context *context, graze_status status, const json *where,
                       const char *format, ...) __attribute__((format(printf, 4, 5)));
/** Put "source:line: path: " before the message of a failure on its way up; returns `status`. */
graze_status json_at(graze_context *context, graze_status status, const json *where);
/** json_at, unless status is GRAZE_OK or the message begins with the source already. */
graze_status json_at_last(graze_context *context, graze_status status, const json *where);

/**
 * Sort the members of an object by key: out[k] is the value of names[k], NULL where it is missing.
 * @return GRAZE_EINPUT not an object, an unknown key, a key twice
 */
graze_status json_members(const json **out, graze_context *context, const json *object,
                          const char *const *names, size_t count);

/** GRAZE_EINPUT unless the value is an array, and of `count` entries where count is not 0. */
graze_status json_array(graze_context *context, const json *value, size_t count);

/** The work of making a polynomial, taking all coefficients to be as long as the longest. */
unsigned long polynomial_work(const fmpz_poly_t p);

/** A number, as JSON number or as expression without t and s. */
graze_status entry_number(fmpq_t out, graze_context *context, const json *value);
/** A number that is an integer. */
graze_status entry_integer(fmpz_t out, graze_context *context, const json *value);

/* Motions from parsed JSON: pieces, keyframes, relative, sequence (src/program/cli/formats.md,
 * Motions). */

/**
 * Read a motion file, or a text in its form (src/program/cli/formats.md, Motions).
 * @return GRAZE_ESYSTEM, GRAZE_EINPUT, GRAZE_EILLEGAL, GRAZE_ELIMIT, GRAZE_ECANCELED
 */
graze_status motion_from_file(graze_motion **out, graze_context *context, const char *path);
graze_status motion_from_text(graze_motion **out, graze_context *context, const char *text,
                              size_t length);

/* One motion seen from another. */

/**
 * frame^-1 moving ([IS] eq. 7) over the times that both have.
 * @return GRAZE_EILLEGAL the dimensions differ, or there is no interval that both have;
 * GRAZE_ELIMIT
 */
graze_status motion_relative(graze_motion **out, graze_context *context, const graze_motion *moving,
                             const graze_motion *frame);

/* A motion as the text of a motion file of plain pieces. */

/** Pieces with a matrix each, whose entries are polynomials in t, or `(A)/(W)` with the piece's one
 * denominator W. */
void motion_write(text *out, const graze_motion *motion);
/** Begin a motion file: its dimension, and a list, "pieces" or "keyframes", in a new line if
 * `apart`. */
json_writer motion_begin(text *out, int dimension, const char *list, int apart);
/** Begin a piece in a line of its own: times, row (0: none) and, within the transform, `kind`,
 * whose bracket is open. */
void motion_begin_piece(json_writer *w, int indent, const fmpq_t from, const fmpq_t to,
                        unsigned long row, const char *kind, char bracket);
/** End the list of pieces, and the file. */
void motion_end(json_writer *w);

#endif
