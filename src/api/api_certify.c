/* The public functions of certificates.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

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

DESTROYER(graze_certifier, certifier_clear(&of->inner))

graze_status graze_certificate_head(char **out, graze_context *context,
                                    const graze_certifier *certifier) {
    PUBLIC_OUT(out, context, certifier);
    HELD(text, t);
    TRY(certify_head(&t, context, &certifier->inner));
    return text_finish(out, context, &t);
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
    char **const to[2] = {table, out};
    size_t *const lengths[2] = {table_length, length};
    return api_points(to, lengths, done, totals, context, certifier->inner.scene, &certifier->inner,
                      points, n, texts, &shown);
}
