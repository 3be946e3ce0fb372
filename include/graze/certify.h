/* graze/certify.h - certificates of answers, which graze-check verifies.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A certificate is its head, one row for each point, and a line `complete N` with the number of
 * rows (proofs/certificate.md).
 */
#ifndef GRAZE_CERTIFY_H
#define GRAZE_CERTIFY_H

#include <graze/report.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Source of the certificates of one scene. It never changes: threads may share it. */
typedef struct graze_certifier graze_certifier;

/** Rows also give the times of the contacts and the boundary cells met. */
#define GRAZE_CERTIFY_TIMES 0x10000u

/**
 * Make a certifier of a scene. Solid and motion must come from files, in E^3 an .off and in E^2 a
 * .wkt, without rounding: graze-check reads no others (graze_solid_text writes one). The scene is
 * borrowed and must outlive the certifier.
 * @param flags those of the call that read the solid, and perhaps GRAZE_CERTIFY_TIMES
 * @return GRAZE_EUSE a NULL handle, a rounding, an unknown flag, or a scene not read from files;
 * GRAZE_EILLEGAL a facet that the fan of triangles about its first corner does not fill;
 * GRAZE_ELIMIT
 */
GRAZE_API GRAZE_CHECKED graze_status graze_certifier_create(graze_certifier **out,
                                                            graze_context *context,
                                                            const graze_scene *scene,
                                                            unsigned flags);
/** Free a certifier. NULL is allowed. */
GRAZE_API void graze_certifier_destroy(graze_certifier *certifier);
/** Head of a certificate. Text for graze_free.
 * @return GRAZE_EUSE, GRAZE_ESYSTEM */
GRAZE_API GRAZE_CHECKED graze_status graze_certificate_head(char **out, graze_context *context,
                                                            const graze_certifier *certifier);
/**
 * Row of a certificate: the answer for a point, and hints with which graze-check proves it.
 * @param[out] out text for graze_free
 * @param point    d canonical rationals
 * @return GRAZE_EUSE, GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_certificate_row(char **out, graze_context *context,
                                                           const graze_certifier *certifier,
                                                           graze_rationals point);
/**
 * Rows of a certificate, and of a table beside it, for n points; each point is traced once.
 * @param[out] out    rows of the certificate for the first *done points as one text for
 * graze_free, also if a later point fails; NULL if *done is 0
 * @param[out] length bytes of the text
 * @param[out] table  rows of the table for the same points, as graze_report_points writes them, and
 * for graze_free too; this and `table_length` are NULL where no table is wanted
 * @param[out] table_length bytes of that text
 * @param[out] done   number of points: n, or on failure the index of the point that failed
 * @param[out] totals totals over the rows of the table, or NULL
 * @param points      n*d canonical rationals, point after point; may be NULL if n is 0
 * @param texts       n of them, one for each row of the table, or NULL
 * @param options     of the table's rows, not GRAZE_COLUMNS_PMC; NULL: the defaults
 * @return GRAZE_EUSE, GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status
graze_certificate_points(char **out, size_t *length, char **table, size_t *table_length,
                         size_t *done, graze_row_totals *totals, graze_context *context,
                         const graze_certifier *certifier, graze_rationals points, size_t n,
                         const graze_row_texts *texts, const graze_row_options *options);

#ifdef __cplusplus
}
#endif
#endif
