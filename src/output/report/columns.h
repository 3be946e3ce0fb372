/* The columns of tables of points: one table, which heads, rows, exports, readers of tables as
 * points and checks of options ask. Each of its sets stands behind the columns of the file of
 * points. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_OUTPUT_REPORT_COLUMNS_H
#define GRAZE_OUTPUT_REPORT_COLUMNS_H

#include "base/number/json.h"
#include "base/number/text.h"
#include "graze/report.h"
#include "input/delimited/delimited.h"
#include "output/table/table.h"

typedef struct row row;

/** How an option of graze classify asks for columns: by being there, or by a width, which is
 * rounded down or up to a double. */
typedef enum column_asked { ASKED_BY_FLAG, ASKED_BY_WIDTH_DOWN, ASKED_BY_WIDTH_UP } column_asked;

/** The part of a trace that decides an answer. */
typedef enum column_needs { NEEDS_PMC, NEEDS_WORD, NEEDS_CONTACTS } column_needs;

/** The name of a column. Older tables may lack one with the mark `?`; one with `*` needs rows of a
 * log, one with `!` a motion. */
typedef struct column_label {
    const char *name;
    char mark; /* or 0 */
} column_label;

/** Columns that one answer fills and one option asks for. */
typedef struct column_set {
    const char *option; /* without its dashes; a line of the head says that it was given */
    size_t at; /* offset in graze_row_options of its int, 0 or 1, or its double, 0: not asked for */
    column_asked asked;
    column_needs needs;
    int beside_sdf;        /* it needs --sdf beside it */
    int at_rest;           /* a solid that does not move has it too */
    int is_exact;          /* it has exact times, which binary rows cannot hold */
    const char *undecided; /* subject of the note on undecided rows; NULL: it needs none */
    int compared;          /* 1: graze compare reads it of golden tables; a word is shown beside a
                              disagreement */
    column_label names[9]; /* ended by a name NULL */
    typed_kind kind;       /* in binary rows */
    graze_status (*find)(row *r, graze_context *context); /* NULL: another set finds it */
    const char *(*word)(const row *r);                    /* its one field, or NULL */
    void (*put)(text *out, const row *r);                 /* CSV, a comma before each field */
    void (*json)(json_writer *w, const row *r);
    void (*note)(text *out, graze_context *context, const graze_scene *scene); /* or NULL */
} column_set;

/** More than the names of all sets. */
enum { COLUMNS_MOST = 32 };

/** The set's member of the options: of ASKED_BY_FLAG; of a width. */
int columns_flag(const column_set *set, const graze_row_options *shown);
double columns_width(const column_set *set, const graze_row_options *shown);
/** The next set after `last` (NULL: the first) that is asked for; NULL behind the last one. */
const column_set *columns_next(const column_set *last, const graze_row_options *shown);
/** Bit k, if this line of a table's head tells of set k; 0 for other lines. */
unsigned columns_of_line(field line);
/** The names of the sets of these bits. Returns their number. */
size_t columns_names(const column_label *out[COLUMNS_MOST], unsigned sets);
/** A column, its set and the set's bit; zeroed: none. */
typedef struct known_column {
    const column_set *set;
    const char *name;
    unsigned bit;
} known_column;
/** Column k, from 0, of those of all sets. */
known_column columns_known(size_t k);
/** The place among these columns of the first one of an option, which the table has. */
size_t columns_place(const char *option);
/** The kinds of the columns that are asked for, in binary rows. Returns their number. */
size_t columns_kinds(typed_kind out[COLUMNS_MOST], const graze_row_options *shown);
/** Append the names of the columns that are asked for, a comma before each. */
void columns_put_names(text *out, const graze_scene *scene, const graze_row_options *shown);

/** Names of all columns that tables of contact points have, comma-joined; the last one where sites
 * are moved. */
extern const char contact_columns[];

#endif
