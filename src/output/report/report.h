/* report: rows of tables, as CSV, JSON Lines and binary values; texts and JSON of verdicts,
 * contacts, positions, distances and events.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_OUTPUT_REPORT_H
#define GRAZE_OUTPUT_REPORT_H

#include "base/number/decimal.h"
#include "decide/bounds/bounds.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "input/motion/motion.h"
#include "output/report/columns.h"
#include "questions/collide/collide.h"
#include "questions/contact/contact.h"
#include "questions/distance/distance.h"
#include "questions/envelope/envelope.h"
#include "questions/outline/outline.h"
#include "questions/topo/topo.h"

/** The first or the last time at which a point is in the closed solid: an end of the motion or of a
 * contact, and its piece. */
typedef struct inside_end {
    const fmpq *end;        /* t0 or t1; borrowed from the motion */
    const graze_time *time; /* NULL if `end` is set, or if the point is never inside; borrowed */
    size_t piece;           /* the first, or the last, piece that has the time, counting its ends */
} inside_end;

/** Both times, or neither. */
typedef struct inside_times {
    inside_end end[2]; /* the first and the last */
    int undecided;     /* a state of the trajectory is undecided, so neither time is given */
} inside_times;

/* A row: the answer for one point, before it is written as text. */

/** A row; `topo` and `regular` are owned, all else is borrowed. */
typedef struct row {
    const graze_scene *scene;
    const graze_row_options *shown; /* checked */
    const fmpq *point;
    const graze_trace *trace;
    graze_row_texts texts; /* set by the caller, after row_answer */
    topo_finding topo;     /* where `shown` has topo */
    topo_finding regular;  /* where it has regular */
    distance space;        /* where it has sdf */
    double boundary;       /* where it has boundary */
    inside_times inside;   /* where it has moments */
} row;

/** The detail of traces that rows with these options need. */
trace_detail row_detail(const graze_row_options *shown);

/** Answer a point that was traced: find everything else that `shown` asks for, and make contact
 * times canonical if they are written. row_clear frees the row in either case. */
graze_status row_answer(row *out, graze_context *context, const graze_scene *scene,
                        const graze_row_options *shown, const fmpq *point,
                        const graze_trace *trace);
void row_clear(row *r);
/** Does the row count as undecided (graze_row_totals)? */
int row_is_undecided(const row *r);

/** Round a bound to a decimal of at most 17 digits that is a bound too: at least the double if
 * `up`, else at most the double. */
enum { BOUND_ROOM = 40 };
void report_bound(char out[BOUND_ROOM], double bound, int up);

/** Write a bound as report_bound rounds it. */
void json_bound(json_writer *w, const char *key, double bound, int up);

/** Find the shortest decimal between a positive double and the next one, above it if `up`, else
 * below it. Rounded towards the double, it gives the double again. */
void report_width(char out[BOUND_ROOM], double value, int up);

/* The sentences of explanations, for texts and for pages: sentences.json, a line for each key. */

/** The content of sentences.json. */
extern const char sentences[] ASSET;

/** Append the sentence of a key. The arguments replace its marks in order: a text for %, an
 * unsigned long for #, a rational for @, a point or a vector with its dimension for ~ or &, a key
 * for $, whose sentence is inserted and takes the arguments after it.
 */
void sentence_put(text *out, const char *key, ...);

/** Append the time of a contact, and its boundary cell. */
void closings_place(text *t, const graze_scene *scene, const germ *g);

/** The decimal of a time in the motion's parameter, as decimal_of_rational makes it. The time
 * becomes canonical. */
char *decimal_of_time(int *exact, const graze_time *time, int digits);

/** Find the origin of times in texts: the motion's start, if it is large compared with the motion's
 * length, as seconds since 1970 are; then 1 is returned. Else the origin is 0, and 0 is returned.
 * `origin` may be NULL. */
int time_origin(fmpq *origin, const graze_motion *motion);

/** Is a time rational? Makes it canonical; the value of a rational time is time->low. */
int time_is_rational(const graze_time *time);

/* Events of an envelope as rows of a table (src/program/cli/formats.md, Envelope). */

/** A row of the table of events, from a canonical time. */
void report_event(text *out, const graze_envelope *envelope, const found_event *event);

/** A row of the table of curves. */
void report_curve(text *out, const graze_curve *curve, const curve_part *part);

/** Rows of the tables of patches and joints, from canonical times. */
void report_patch(text *out, const graze_patches *patches, size_t index);
void report_joint(text *out, const graze_patches *patches, size_t index);

/* Explains the answer for one point to a person. */

/** Write the whole explanation; the times of the row's trace are canonical. */
graze_status report_explain(char **out, graze_context *context, const row *r);

/* Answers as lines of JSON (src/program/cli/formats.md, JSON Lines). */

/** Add one line of JSON. */
void report_json(text *out, const row *r);

/* How two solids meet, in words and as JSON (src/program/cli/formats.md, Collisions). */

/** "clear", "touch", "overlap", "meets", else "none". Static. */
const char *pair_verdict_name(graze_pair_verdict verdict);
/** "vertex-facet" and so on, the moving one first; "" for none. Static. */
const char *cell_pair_name(const graze_cell_pair *cells);

/** Append the lines of a pair: verdict, word, contacts. */
void pair_text(text *out, const graze_pair *pair);
/** Append the object of a pair. */
void pair_json(text *out, const graze_pair *pair);
/** Append the fields of a pair in a table, from verdict to cells. */
void pair_fields(text *out, const graze_pair *pair);
/** The verdict as objects and tables have it. Static. */
const char *pair_verdict_word(const graze_pair *pair);

/* Outlines (src/program/cli/formats.md, Outlines). Points get their coordinates when they are
 * written. */

/** Append the numbers of an outline, a line each. */
graze_status outline_text(text *out, graze_context *context, const graze_outline *o);
/** Append an outline as an object. */
graze_status outline_json(text *out, graze_context *context, const graze_outline *o);
/** Append the table of an outline's arcs. */
graze_status outline_csv(text *out, graze_context *context, const graze_outline *o);
/** Append points of an outline's crossing segments, as graze_outline_samples has them. */
graze_status outline_samples(text *out, graze_context *context, const graze_outline *o);
/** Append the polygons of an outline. */
void outline_polygon_text(text *out, const outline_polygon *p, graze_polygon_format format);

/* Sites as rows of a table or lines of JSON (src/program/cli/formats.md, Contact points). */

/** A row, from canonical times. @param rest further columns, or NULL */
void report_contact_csv(text *out, const graze_site *site, const char *rest);
void report_contact_json(text *out, const graze_site *site);

/** Tables whose rows are not points. */
typedef enum report_table {
    TABLE_EVENTS,
    TABLE_CURVES,
    TABLE_PATCHES,
    TABLE_JOINTS,
    TABLE_SITES,
    TABLE_ARCS
} report_table;

/** Write the head of such a table: `#` lines and the line of column names.
 * @param notes further `# key value` lines, or NULL
 * @param further further names, comma-joined, or NULL */
graze_status report_table_head(char **out, graze_context *context, const graze_scene *scene,
                               report_table table, const char *notes, const char *further);

/* The table of a scene and its points (src/program/cli/formats.md, Tables). */

/** Write the head of a table of points; `notes` may be NULL.
 * @param columns names of further columns, or NULL */
graze_status report_header(char **out, graze_context *context, const graze_scene *scene,
                           const char *notes, const char *columns, const graze_row_options *shown);
/** Append the names of that table's columns. */
void table_columns(text *out, const graze_scene *scene, const char *columns,
                   const graze_row_options *shown);

/** Add one row of the table. */
void report_csv(text *out, const row *r);

/** Add one row of values (output/table/table.h). GRAZE_EINPUT: a coordinate is past binary64.
 */
graze_status report_values(text *out, graze_context *context, const row *r);

#endif
