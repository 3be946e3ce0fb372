/* Parts of rows and texts: times, values, formulas.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_OUTPUT_REPORT_ROW_PARTS_H
#define GRAZE_OUTPUT_REPORT_ROW_PARTS_H

#include <flint/fmpq_poly.h>
#include "output/report/report.h"

/* The first and the last time at which a point is in the closed solid (src/program/cli/formats.md,
 * Tables). */

/** Find both times from the row's trace with contacts (proofs/claims.md C8); the times become
 * canonical. GRAZE_ELIMIT, GRAZE_ECANCELED. */
graze_status inside_find(row *r, graze_context *context);
/** Append the fields of both times, a comma before each; also their rows of a log if the motion has
 * them. */
void inside_csv(text *out, const row *r);
/** Add both times to a JSON object. */
void inside_json(json_writer *w, const row *r);

/* Enclosures of distances in tables, in JSON and in explanations. */

/** Append the three columns of an enclosure, a comma before each: an irrational time of a contact
 * is a decimal of 17 digits. */
void report_distance(text *out, const row *r);

/** Append a paragraph about an enclosure for a person. */
void explain_distance(text *out, const graze_scene *scene, const distance *found);

/* Explanations, for a person, of a position relative to the closed sweep. */

/** Append the position of a point, the level that decided it, and its witness or the reason why it
 * is undecided; if `is_regular`, whether it is in the closure of an unsweep's interior. */
void closed_explain(text *t, const topo_finding *topo, int is_regular, int dimension);

/* Explanations, for a person, of the directions about a point that each of its contacts covers. */

/** Append a linear form of a direction, such as `dx + -2 dy`. */
void closings_form(text *t, const fmpz *normal, int dimension);

/** Append a line for each contact of an `on` point with the directions covered; for an unsweep the
 * solid's complement covers them. If the position is undecided, append the nearest point found that
 * is `out`. */
graze_status closings_explain(text *t, graze_context *context, const graze_scene *scene,
                              const fmpq *point, const topo_finding *topo);

/* Times as text: exact, and as correctly rounded decimals. */
/** The decimal of the difference of a time and `since`, in the form of decimal_of_time. */
char *decimal_of_time_since(int *exact, const graze_time *time, const fmpq_t since, int digits);

/** Append a canonical time: a ratio, or root(c0 c1 ...;a;b); nothing for NULL. */
void report_put_time(text *t, const graze_time *time);
/** Append a canonical time, a comma, and its decimal of 17 digits; only a comma for NULL. */
void report_put_time_near(text *t, const graze_time *time);

/* Rational functions, polynomials and numbers as a person reads them. */

/** Append a coordinate of the trajectory on a piece as a rational function of the motion's
 * parameter in lowest terms, such as `(2*t^2 - 1)/(t^2 + 1)`. A long function is shortened, and the
 * text says how many terms are left out.
 */
void formula_coordinate(text *out, const motion_piece *piece, const point_map *map, int coordinate,
                        const fmpq *point);
/** Append a quotient in the same form, whose numerator and weight are polynomials of a piece's u
 * and are brought to lowest terms; `piece` is NULL where they stay in their own variable. Nothing
 * is left out if `whole`, the variable's name, is not NULL. */
void formula_quotient(text *out, fmpq_poly_t numerator, fmpq_poly_t weight,
                      const motion_piece *piece, const char *whole);
/** Append an integer polynomial in t, highest power first; shortened like a coordinate. */
void formula_polynomial(text *out, const fmpz_poly_t polynomial);
/** Append a rational; if it has many digits, the number of the middle digits replaces them. */
void formula_rational(text *out, const fmpq_t value);

/* Answers as values of JSON (src/program/cli/formats.md, JSON Lines). */

/** Write a count; null unless `is_there`. */
void json_index(json_writer *w, const char *key, int is_there, size_t value);
/** Write a cell as an object. */
void json_cell(json_writer *w, const char *key, const graze_cell *cell);
/** Write the members of json_cell's object. */
void json_cell_members(json_writer *w, const graze_cell *cell);
/** Write "intersection" or "tangency"; null for kind 0. */
void json_contact_kind(json_writer *w, const char *key, graze_kind kind);
/** Write "I", "B" or "O"; null beyond an end of the motion. */
void json_state(json_writer *w, const char *key, graze_state state);
/** Write a time (src/program/cli/formats.md, TIME), which becomes canonical; null for NULL. */
void json_time(json_writer *w, const char *key, const graze_time *time);

/** Write the enclosure of a row. */
void json_distance(json_writer *w, const row *r);
/** Write the answer under the key `question`; the keys of level or reason and of the witness begin
 * with this name. */
void json_position(json_writer *w, const char *question, const char *answer,
                   const topo_finding *found, int dimension);

/** Append a line `# name width` with report_width's decimal, unless the width is 0. */
void report_put_width(text *out, const char *name, double width, int up);

/** Append a cell: `face 3`, `edge 1-2`, `vertex 5`; nothing for kind 0. */
void report_put_cell(text *t, const graze_cell *cell);

/** Append "+", "-" or "0"; nothing for GRAZE_SIGN_ABSENT. */
const char *report_sign(int sign);

/* Times in sentences and pictures: as numbers, or relative to t0 where t0 is large (time_origin).
 */

/** Append a time as a ratio, such as `1/3`; from a large t0 on as `t0 + 0.02`, or with a ratio
 * where no short decimal is exact. */
void tell_rational_time(text *out, const graze_motion *motion, const fmpq_t time);

/** Append a time: `1/2 = 0.5`, `1/3, about 0.333333333333`, `t0 + 1/3, about t0 + 0.333333333333`,
 * or a root with its polynomial and interval. */
void tell_time(text *out, const graze_time *time);

/** Append an irrational time as a decimal with `digits` digits. */
void tell_near_time(text *out, const graze_time *time, int digits);

/** Append a sentence with the value of t0, if times are given relative to it. */
void tell_time_origin(text *out, const graze_motion *motion);

#endif
