/* The public functions of certificates.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include "base/context/scope.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"
#include "output/report/report.h"
#include "questions/certify/certify.h"

struct graze_certifier {
    certifier inner;
};

graze_status graze_certifier_create(graze_certifier **out, graze_context *context,
                                    const graze_scene *scene, unsigned flags) {
    PUBLIC_OUT(out, context, scene);
    REFUSED(flags & ~(GRAZE_SOLID_TRIANGULATE | GRAZE_CERTIFY_TIMES), "a flag is unknown");
    TRY(api_takes(context, "graze_certifier_create", scene->solid));
    CREATE(out, made, free, certifier_make(&made->inner, context, scene, flags));
}

void graze_certifier_destroy(graze_certifier *certifier) {
    if (!certifier)
        return;
    certifier_clear(&certifier->inner);
    free(certifier);
}

graze_status graze_certificate_head(char **out, graze_context *context,
                                    const graze_certifier *certifier) {
    PUBLIC_OUT(out, context, certifier);
    HELD(text, t);
    TRY(certify_head(&t, context, &certifier->inner));
    return text_finish(out, context, &t);
}

/* Trace one point and write its row of the certificate and, unless `table` is NULL, its row of the
 * table. */
static graze_status certify_point(text *out, text *table, graze_row_totals *totals,
                                  graze_context *context, const certifier *c, const fmpq *point,
                                  const graze_row_texts *texts, const graze_row_options *shown) {
    graze_trace trace;
    trace_detail detail = table ? row_detail(shown) : TRACE_WORD;
    TRY(classify_point(&trace, context, c->scene, (query_point){.rational = point},
                       c->with_contacts ? TRACE_CONTACTS : detail));
    graze_status status = certify_row(out, context, c, point, &trace);
    if (!status && out->failed)
        status = context_fail(context, GRAZE_ESYSTEM, "out of memory");
    if (!status && table)
        status = api_row(table, totals, context, c->scene, point, &trace, texts, shown);
    trace_clear(&trace);
    return status;
}

graze_status graze_certificate_row(char **out, graze_context *context,
                                   const graze_certifier *certifier, graze_rationals point) {
    PUBLIC_OUT(out, context, certifier, point);
    size_t length, done;
    return graze_certificate_points(out, &length, NULL, NULL, &done, NULL, context, certifier,
                                    point, 1, NULL, NULL);
}

graze_status graze_certificate_points(char **out, size_t *length, char **table,
                                      size_t *table_length, size_t *done, graze_row_totals *totals,
                                      graze_context *context, const graze_certifier *certifier,
                                      graze_rationals points, size_t n,
                                      const graze_row_texts *texts,
                                      const graze_row_options *options) {
    graze_row_options shown;
    EMPTY(totals);
    EMPTY(out);
    EMPTY(table);
    EMPTY(length);
    EMPTY(table_length);
    EMPTY(done);
    REFUSED(!out || !length || !table != !table_length || !done || !context || !certifier ||
                (n && !points),
            "out, length, done, context and certifier, and with n > 0 also points, "
            "must not be NULL; nor one alone of table and table_length");
    TRY(api_rows(&shown, context, __func__, options));
    REFUSED(shown.columns == GRAZE_COLUMNS_PMC,
            "a certificate needs all answers; expected no columns of pmc alone");
    IN_ENVIRONMENT();
    graze_status status = GRAZE_OK;
    size_t d = (size_t)certifier->inner.scene->motion->dimension, whole = 0, whole_rows = 0;
    LOCAL_VEC(fmpq, point, (slong)d);
    text certificate, rows;
    text_init(&certificate);
    text_init(&rows);
    for (size_t k = 0; k < n && !status; k++) {
        status = api_point(point, context, certifier->inner.scene, points + k * d);
        if (!status)
            status = certify_point(&certificate, table ? &rows : NULL, totals, context,
                                   &certifier->inner, point, texts ? texts + k : NULL, &shown);
        whole = status ? whole : certificate.length;
        whole_rows = status ? whole_rows : rows.length;
        *done += !status;
    }
    api_whole_rows(out, length, &certificate, whole);
    if (table)
        api_whole_rows(table, table_length, &rows, whole_rows);
    return status;
}
