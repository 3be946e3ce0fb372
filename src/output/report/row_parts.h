/* Parts of rows and texts: times, values, formulas.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_OUTPUT_REPORT_ROW_PARTS_H
#define GRAZE_OUTPUT_REPORT_ROW_PARTS_H

#include "base/number/decimal.h"
#include "base/number/json.h"
#include "base/number/text.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "input/motion/motion.h"
#include "output/report/report.h"
#include "questions/distance/distance.h"
#include "questions/topo/topo.h"

/* The first and the last time at which a point is in the closed solid (src/program/cli/formats.md,
 * Tables). */

/** Find both times from the row's trace with contacts (proofs/claims.md C8); the times become
 * canonical. GRAZE_ELIMIT, GRAZE_ECANCELED. */
graze_status inside_find(row *r, graze_context *context);
/** Append their fields, a comma before each; fields for rows of a log if the motion has them. */
void inside_csv(text *out, const row *r);
/** Add them to a JSON object. */
void inside_json(json_writer *w, const row *r);

/* Enclosures of distances in tables, JSON and explanations. */

/** Append the time of an enclosure: a ratio, or a decimal of 17 digits for an irrational time of a
 * contact.
 */
void report_distance_time(text *out, const graze_scene *scene, const distance *found);

/** Does every motion within the error have the same answer? "yes" or "undecided"; static. */
const char *report_certainty(const distance *found, double motion_error);

/** Append the three columns of an enclosure, a comma before each. */
void report_distance(text *out, const row *r);

/** Append a paragraph about an enclosure for a person. */
void explain_distance(text *out, const graze_scene *scene, const distance *found);

/* Explains a position relative to the closed sweep to a person. */

/** Append the position of a point, the level that decided it, and its witness or the reason why it
 * is undecided. */
void closed_explain(text *t, const topo_finding *topo, int dimension);

/** Append whether a point is in the closure of an unsweep's interior, in the same form. */
void closed_explain_regular(text *t, const topo_finding *regular, int dimension);

/* Explains to a person the directions about a point that each of its contacts covers. */

/** Append a linear form of a direction, such as `dx + -2 dy`. */
void closings_form(text *t, const fmpz *normal, int dimension);

/** Append a line for each contact of an `on` point; for an unsweep the solid's complement is what
 * covers. If the position is undecided, append the nearest point found that is out. */
graze_status closings_explain(text *t, graze_context *context, const graze_scene *scene,
                              const fmpq *point, const topo_finding *topo);

/* Times as text: exact, and as correctly rounded decimals. */
/** The decimal of a time minus `since`, as decimal_of_time gives that of a time. */
char *decimal_of_time_since(int *exact, const graze_time *time, const fmpq_t since, int digits);

/** Append a canonical time: a ratio, or root(c0 c1 ...;a;b); nothing for NULL. */
void report_put_time(text *t, const graze_time *time);
/** Append a rational or a canonical time, a comma, and its decimal of 17 digits; only a comma for
 * NULL.
 */
void report_put_rational_near(text *t, const fmpq_t value);
void report_put_time_near(text *t, const graze_time *time);

/* Rational functions, polynomials and numbers as a person reads them. */

/** Append a coordinate of the trajectory on a piece as a rational function of the motion's
 * parameter in lowest terms, such as `(2*t^2 - 1)/(t^2 + 1)`. A long one is shortened, with the
 * number of terms left out.
 */
void formula_coordinate(text *out, const motion_piece *piece, const point_map *map, int coordinate,
                        const fmpq *point);
/** Append an integer polynomial in t, highest power first; shortened like a coordinate. */
void formula_polynomial(text *out, const fmpz_poly_t polynomial);
/** Append a rational; if it has many digits, the middle ones are replaced by their number. */
void formula_rational(text *out, const fmpq_t value);

/* Answers as values of JSON (src/program/cli/formats.md, JSON Lines). */

/** Write a count, or null unless `is_there`. */
void json_index(json_writer *w, const char *key, int is_there, size_t value);
/** Write a cell as an object. */
void json_cell(json_writer *w, const char *key, const graze_cell *cell);
/** "intersection" or "tangency"; null for 0. */
void json_contact_kind(json_writer *w, const char *key, graze_kind kind);
/** "I", "B", "O", or null beyond an end of the motion. */
void json_state(json_writer *w, const char *key, graze_state state);
/** A time (src/program/cli/formats.md, TIME); makes it canonical. NULL: null. */
void json_time(json_writer *w, const char *key, const graze_time *time);

/** Write a bound as report_bound rounds it. */
void json_bound(json_writer *w, const char *key, double bound, int up);
/** Write the enclosure of a row. */
void json_distance(json_writer *w, const row *r);
/** Write the answer to `question`, which begins the keys of its level or reason and its witness. */
void json_position(json_writer *w, const char *question, const char *answer,
                   const topo_finding *found, int dimension);

/** Append a line `# name width` with report_width's decimal, unless the width is 0. */
void report_put_width(text *out, const char *name, double width, int up);

/** A cell: `face 3`, `edge 1-2`, `vertex 5`; nothing for kind 0. */
void report_put_cell(text *t, const graze_cell *cell);

/** Write the head of a table of other rows than points: `#` lines and names.
 * @param notes further `# key value` lines, or NULL.
 * @param further names behind `names`, comma-joined, or NULL */
graze_status table_head(char **out, graze_context *context, const graze_scene *scene,
                        const char *notes, const char *names, const char *further);

/* Times in sentences and pictures: as numbers, or from t0 where that is large (time_origin). */

/** `1/3`, or `t0 + 0.02`, with a ratio where no short decimal is the number itself. */
void tell_rational_time(text *out, const graze_motion *motion, const fmpq_t time);

/** `1/2 = 0.5`, `1/3, about 0.333333333333`, `t0 + 1/3, about t0 + 0.333333333333`, or the root
 * with its polynomial and interval. */
void tell_time(text *out, const graze_time *time);

/** Append an irrational time as a decimal with `digits` digits. */
void tell_near_time(text *out, const graze_time *time, int digits);

/** Append a sentence with the value of t0, if times are given relative to it. */
void tell_time_origin(text *out, const graze_motion *motion);

#endif
