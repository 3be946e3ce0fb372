/* graze/report.h - tables, JSON Lines, exports and explanations.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A table is graze_report_header, then rows, then a line `# complete N` (formats.md, Tables). Rows
 * of one scene may be made by several threads, each with its own context. One struct of options
 * says what rows show, for the head and all rows of a table.
 */
#ifndef GRAZE_REPORT_H
#define GRAZE_REPORT_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A grid of query points (graze/grid.h). */
typedef struct graze_grid graze_grid;

/** SHA-256 hashes, as in the head of a table: of the two files (zeros if the input came from
 * memory), and of the scene after rounding and triangulation. */
typedef struct graze_hashes {
    unsigned char solid[32], motion[32], scene[32];
} graze_hashes;

/** Hashes of a scene; zeros for NULL. */
GRAZE_API graze_hashes graze_scene_hashes(const graze_scene *scene);

/**
 * Write a rational as a decimal, with an exponent if it is small (`1.5e-9`) or is rounded before
 * the units (`1.2e5`).
 * @param[out] out text for graze_free
 * @param value    canonical
 * @param digits   0: the number itself; 1 to 1000: at most this number of significant digits,
 * rounded to nearest, ties to even
 * @return GRAZE_EUSE; GRAZE_EINPUT digits is 0 and the number has no finite decimal; GRAZE_ELIMIT;
 * GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_number_decimal(char **out, graze_context *context,
                                                          const mpq_t value, int digits);

/** Form of rows. */
typedef enum graze_format {
    GRAZE_FORMAT_CSV = 0,
    GRAZE_FORMAT_JSONL = 1, /**< with every contact and its exact times */
    GRAZE_FORMAT_VTK = 2,   /**< binary rows, from which graze_report_export makes a file: a legacy
                               VTK file, binary: a grid as structured points, else vertices; all
                               columns as point data. pmc, class and definition (ext: 0) are
                               numbers, texts are numbered by first occurrence, and the field data
                               COLUMN_texts has their bytes, each with a newline behind it */
    GRAZE_FORMAT_NPY = 3    /**< the same rows, for a structured numpy array: float64, uint32
                               (definition, case, i, t; ext: 0), and bytes */
} graze_format;

/** Columns and form of rows (rule 6). */
typedef struct graze_row_options {
    size_t size; /**< sizeof(graze_row_options) */
    graze_format format;
    graze_columns columns; /**< GRAZE_COLUMNS_PMC goes with no other answer (topo, regular, sdf,
                              moments) and not with JSON Lines */
    int topo;   /**< 1: the position relative to the closed sweep (graze/topo.h), in the last column
                  or before that of `regular` */
    double sdf; /**< an enclosure of the signed distance of at most this width (graze/distance.h);
                   0: none */
    double motion_error; /**< with sdf: adds the column `certain`: whether pmc holds for every
                            continuous motion within this displacement of each point
                            (proofs/distance.md C73); 0: no column */
    int moments; /**< 1: the first and the last time at which the point is in the closed solid, with
                    their pieces and rows of a log (formats.md); CSV and JSON Lines */
    int regular; /**< 1: for an unsweep, a last column: whether the point is in the closure of the
                    unsweep's interior (graze_trace_regular) */
    int boundary; /**< 1: with sdf, a lower bound of the distance from the boundary: all points
                     nearer to this point than the bound have its pmc (proofs/judging.md C120) */
    int at_rest; /**< 1: rows of a solid that does not move (graze_scene_at_rest): pmc, with sdf its
                    enclosure without a time, also as JSON Lines; `columns` has no effect, and the
                    other answers are refused */
} graze_row_options;

/** Texts of one row, comma-joined and unchanged; each may be NULL. JSON Lines have none. */
typedef struct graze_row_texts {
    const char *point; /**< CSV: the coordinates, in place of integers and ratios */
    const char *rest;  /**< further columns */
} graze_row_texts;

/**
 * Write the head of a CSV table: its `#` lines and its column line (formats.md, Tables).
 * @param[out] out text for graze_free
 * @param notes    further lines, each `# key value` and a newline, or NULL
 * @param columns  names of further columns, comma-joined and unchanged, or NULL
 * @param options  of the rows; NULL: the defaults
 * @return GRAZE_EUSE, GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_report_header(char **out, graze_context *context,
                                                         const graze_scene *scene,
                                                         const char *notes, const char *columns,
                                                         const graze_row_options *options);
/**
 * Write one row with its newline, from the trace of its point.
 * @param[out] out text for graze_free
 * @param point    d canonical rationals: the point that was traced
 * @param texts    or NULL
 * @param options  CSV or JSON Lines; NULL: the defaults
 * @return GRAZE_EUSE, GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_report_row(
    char **out, graze_context *context, const graze_scene *scene, graze_rationals point,
    const graze_trace *trace, const graze_row_texts *texts, const graze_row_options *options);
/**
 * Trace a point and write its row: the bytes of graze_trace_create and graze_report_row. A CSV row
 * needs no contact times and is much faster this way.
 * @return as graze_trace_create; GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_report_point(char **out, graze_context *context,
                                                        const graze_scene *scene,
                                                        graze_rationals point,
                                                        const graze_row_texts *texts,
                                                        const graze_row_options *options);
/** Totals over rows. */
typedef struct graze_row_totals {
    unsigned long undecided; /**< rows with an undecided position or, of a curved solid, an
                                undecided word (with GRAZE_COLUMNS_PMC: pmc) */
    unsigned long wide;      /**< rows with an enclosure wider than was asked for */
} graze_row_totals;

/**
 * Trace n points and write their rows one after the other, as graze_report_point does for one.
 * @param[out] out    rows of the first *done points as one text for graze_free, also if a later
 * point fails; NULL if *done is 0
 * @param[out] length bytes of the text
 * @param[out] done   number of rows written: n, or on failure the index of the point that failed
 * @param[out] totals totals over the rows written, or NULL
 * @param points      n*d canonical rationals, point after point; may be NULL if n is 0
 * @param texts       of each row, or NULL
 * @param options     NULL: the defaults
 * @return as graze_report_point; GRAZE_EINPUT a coordinate past binary64, in a binary row
 */
GRAZE_API GRAZE_CHECKED graze_status
graze_report_points(char **out, size_t *length, size_t *done, graze_row_totals *totals,
                    graze_context *context, const graze_scene *scene, graze_rationals points,
                    size_t n, const graze_row_texts *texts, const graze_row_options *options);

/**
 * Make the file of a whole table of binary rows. Coordinates and further columns of numbers are the
 * nearest binary64, ties to even; one past its range is refused.
 * @param[out] out    bytes for graze_free
 * @param[out] length number of bytes
 * @param rows        rows_length bytes of graze_report_points, or of graze_grid_rows, of one
 * program on one machine, with these options
 * @param columns     names of further columns, comma-joined, or NULL
 * @param grid        the grid whose points these are, all and in its order, or NULL
 * @param options     GRAZE_FORMAT_VTK or GRAZE_FORMAT_NPY, and the others as of the rows
 * @return GRAZE_EUSE another form; GRAZE_EINPUT not whole rows; GRAZE_ELIMIT; GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_report_export(char **out, size_t *length,
                                                         graze_context *context,
                                                         const graze_scene *scene, const char *rows,
                                                         size_t rows_length, const char *columns,
                                                         const graze_grid *grid,
                                                         const graze_row_options *options);
/**
 * Explain the answer for one point in plain text: position, trajectory, contacts in order of time
 * with the reason for the kind of each, counts, definition and case; position relative to the
 * closed sweep and distance where the options have them.
 * @param[out] out text for graze_free
 * @param point    d canonical rationals: the point that was traced
 * @param options  topo, regular, sdf and motion_error; NULL: none
 * @return GRAZE_EUSE, GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_report_explain(char **out, graze_context *context,
                                                          const graze_scene *scene,
                                                          graze_rationals point,
                                                          const graze_trace *trace,
                                                          const graze_row_options *options);
/**
 * Verdict of a word: the word gives the counts; counts and ends of the word give case and class.
 * This is the rule alone, for checking rows of a table; no point is classified.
 * @param[out] out zero on failure
 * @param word     `length` letters, which need not end in NUL
 * @param options  those of the scene, or NULL for the defaults
 * @return GRAZE_EUSE a NULL or an unknown option; GRAZE_EINPUT not a word: expected letters O, I,
 * B, every second one B
 */
GRAZE_API GRAZE_CHECKED graze_status graze_word_verdict(graze_verdict *out, graze_context *context,
                                                        const char *word, size_t length,
                                                        const graze_options *options);

#ifdef __cplusplus
}
#endif
#endif
