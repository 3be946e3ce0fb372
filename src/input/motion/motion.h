/* motion: reads a motion file's JSON and checks the motion, which becomes point maps of itself and
 * its inverse.
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

/** The most entries of a point map, which has dimension * (dimension + 1). */
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
    unsigned long row; /* the line of a log from which the piece comes; 0: none */
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
/** The inverse of motion_tracing's map: it carries points of the solid to the space of the query
 * points.
 */
const point_map *motion_placing(const motion_piece *piece, graze_operation operation);

/** Set the motion's parameter t = lo + (hi - lo) u of a piece, or the piece's parameter u at t;
 * both may be one number. */
void motion_time_at(fmpq_t t, const motion_piece *piece, const fmpq_t u);
void motion_parameter_at(fmpq_t u, const motion_piece *piece, const fmpq_t t);

void point_map_init(point_map *map, int dimension);
void point_map_clear(point_map *map);
void point_map_set(point_map *out, const point_map *map);

/** Set `out` to the affine map that a point map is at u: d*(d+1) initialised rationals, row by row.
 */
void point_map_at(fmpq *out, const point_map *map, const fmpq_t u);

/** Set the square of the factor by which a map multiplies all lengths, times the square of its
 * weight; 0 if the map changes their ratios. */
int point_map_scale(fmpz_poly_t out, const point_map *map);

/** The sign of the determinant of an affine map as point_map_at gives it. */
int affine_orientation(const fmpq *map, int d);
/** The image of a point under such a map; `out` is not the point. */
void affine_image(fmpq *out, const fmpq *map, const fmpq *point, int d);

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

/** One value, in one block of memory with its text and its key. Children stand in the order of the
 * text; an object's may repeat a key. */
typedef struct json {
    json_kind kind;
    size_t line; /* from 1 */
    char *text;  /* token of a number or decoded bytes of a string, then a NUL; else NULL */
    size_t length;
    char *key; /* of a member of an object; a NUL follows, and may stand inside */
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
/** Put "source:line: path: " before the message of a failure on its way up; returns `status`, which
 * may be GRAZE_OK. */
graze_status json_at(graze_context *context, graze_status status, const json *where);
/** json_at, unless status is GRAZE_OK or the message begins with the source already. */
graze_status json_at_last(graze_context *context, graze_status status, const json *where);

/**
 * Look up the members of an object by key: out[k] is the value of names[k], or NULL if the key is
 * missing.
 * @return GRAZE_EINPUT the value is no object, or has an unknown key or a key twice
 */
graze_status json_members(const json **out, graze_context *context, const json *object,
                          const char *const *names, size_t count);

/** Return GRAZE_EINPUT unless the value is an array, of `count` entries if `count` is not 0. */
graze_status json_array(graze_context *context, const json *value, size_t count);

/** The work of making a polynomial, counted as if all coefficients were as long as the longest. */
unsigned long polynomial_work(const fmpz_poly_t p);

/** Read a number: a JSON number or an expression without t and s. */
graze_status entry_number(fmpq_t out, graze_context *context, const json *value);
/** Read a number that must be an integer. */
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
 * Set *out to frame^-1 moving ([IS] eq. 7), over the times at which both motions are defined.
 * @return GRAZE_EILLEGAL the dimensions differ, or the motions have no interval of time in common;
 * GRAZE_ELIMIT
 */
graze_status motion_relative(graze_motion **out, graze_context *context, const graze_motion *moving,
                             const graze_motion *frame);

/* A motion as the text of a motion file of plain pieces. */

/** Write a motion as pieces with a matrix each. Its entries are polynomials in t, or `(A)/(W)` with
 * one denominator W for the piece. */
void motion_write(text *out, const graze_motion *motion);
/** Begin a motion file: write the dimension and open a list, "pieces" or "keyframes", on a new line
 * if `apart`. */
json_writer motion_begin(text *out, int dimension, const char *list, int apart);
/** Begin a piece on a line of its own: write its times and its row, unless that is 0, and open its
 * transform and in it the member `kind` by `bracket`. */
void motion_begin_piece(json_writer *w, int indent, const fmpq_t from, const fmpq_t to,
                        unsigned long row, const char *kind, char bracket);
/** Write a piece with a matrix. */
void motion_put_piece(json_writer *w, const motion_piece *piece);
/** End the list of pieces, and the file. */
void motion_end(json_writer *w);

#endif
