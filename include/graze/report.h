/* graze/report.h - tables, JSON Lines, exports and explanations.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_H
#define GRAZE_REPORT_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How rows are written. */
typedef enum graze_format { GRAZE_FORMAT_CSV = 0, GRAZE_FORMAT_JSONL = 1 } graze_format;

/**
 * The `#` lines of a CSV table and its column line (formats.md, Tables).
 * @param notes   further lines, each `# key value` and a newline, or NULL: what the scene does not
 * know, such as the grid
 * @param columns names of further columns as they were, comma-joined, or NULL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_report_header(char **out, graze_context *context,
                                                         const graze_scene *scene,
                                                         const char *notes, const char *columns);
/**
 * One row with its newline.
 * @param point the point the trace was made of
 * @param rest  the further columns as they were, or NULL; CSV only
 */
GRAZE_API GRAZE_CHECKED graze_status graze_report_row(char **out, graze_context *context,
                                                      const graze_scene *scene, const mpq_t *point,
                                                      const graze_trace *trace, graze_format format,
                                                      const char *rest);
/**
 * Trace a point and write its row, as graze_trace_create and graze_report_row do one after the
 * other. A CSV row needs no contact times, which makes it much faster.
 * @param point d rationals in lowest terms
 */
GRAZE_API GRAZE_CHECKED graze_status graze_report_point(char **out, graze_context *context,
                                                        const graze_scene *scene,
                                                        const mpq_t *point, graze_format format,
                                                        const char *rest);
/**
 * Trace n points and write their rows one after the other, as graze_report_point does for one.
 * @param[out] out    the rows of the first *done points as one text for graze_free, also when a
 * later one fails; NULL when *done is 0
 * @param[out] length bytes of the text
 * @param[out] done   points that have their rows: n, or on any status but GRAZE_OK the index of the
 * point that failed
 * @param points      n*d rationals in lowest terms, point after point; may be NULL when n is 0
 * @param rest        the further columns of each point as they were, entries may be NULL; or NULL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_report_points(
    char **out, size_t *length, size_t *done, graze_context *context, const graze_scene *scene,
    const mpq_t *points, size_t n, graze_format format, const char *const *rest);
/** Binary forms of a whole table. */
typedef enum graze_export {
    GRAZE_EXPORT_NONE = 0,
    GRAZE_EXPORT_VTK = 1, /**< legacy VTK, binary: a grid as structured points, else vertices; all
                             columns as point data. pmc, class and definition (ext: 0) are numbers,
                             texts are numbered by their first occurrence, and the field data
                             COLUMN_texts has them as bytes, each with a newline behind it */
    GRAZE_EXPORT_NPY = 2  /**< a structured numpy array: float64, uint32 (definition, case, i, t;
                             ext: 0), and bytes */
} graze_export;

/**
 * Turn a whole CSV table into another form. Coordinates and further columns of numbers become the
 * nearest binary64.
 * @param[out] out, length bytes for graze_free
 * @param table            from its first `#` line to `# complete N`; it need not end in NUL
 * @return GRAZE_EUSE no such form; GRAZE_EINPUT not a whole table; GRAZE_ELIMIT; GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_report_export(char **out, size_t *length,
                                                         graze_context *context, const char *table,
                                                         size_t table_length, graze_export form);
/** The whole reasoning for one point, for a person to read: where it is, the trajectory, the
 * contacts in order of time and why each counts as what it does, the counts, the definition and the
 * case. */
GRAZE_API GRAZE_CHECKED graze_status graze_report_explain(char **out, graze_context *context,
                                                          const graze_scene *scene,
                                                          const mpq_t *point,
                                                          const graze_trace *trace);

#ifdef __cplusplus
}
#endif
#endif
