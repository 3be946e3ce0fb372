/* The public functions of curves of contact.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include "output/report/report.h"
#include "questions/contact/contact.h"
#include "questions/envelope/envelope.h"

graze_status graze_curve_create(graze_curve **out, graze_context *context,
                                const graze_envelope *envelope, const mpq_t time) {
    PUBLIC_OUT(out, context, envelope, time);
    LOCAL(fmpq, t);
    TRY(api_rational(t, context, time));
    CREATE(out, made, free, contact_curve_make(made, context, envelope, t));
}

DESTROYER(graze_curve, contact_curve_clear(of))
FACT(size_t, graze_curve_count, graze_curve, of->count, 0)

graze_curve_part graze_curve_at(const graze_curve *curve, size_t index) {
    graze_curve_part none = {0};
    return index < graze_curve_count(curve) ? curve->part[index].facts : none;
}

void graze_curve_ends(mpq_t *a, mpq_t *b, const graze_curve *curve, size_t index) {
    if (!a || !b || index >= graze_curve_count(curve))
        return;
    api_point_out(a, curve->part[index].a, curve->dimension);
    api_point_out(b, curve->part[index].b, curve->dimension);
}

graze_status graze_curve_header(char **out, graze_context *context, const graze_envelope *envelope,
                                const char *notes) {
    PUBLIC_OUT(out, context, envelope);
    return report_table_head(out, context, envelope->scene, TABLE_CURVES, notes, NULL);
}

graze_status graze_curve_row(char **out, graze_context *context, const graze_curve *curve,
                             size_t index) {
    PUBLIC_OUT(out, context, curve);
    REFUSED(index >= curve->count, "there is no such part");
    HELD(text, t);
    report_curve(&t, curve, &curve->part[index]);
    return text_finish(out, context, &t);
}

graze_status graze_envelope_site(graze_site **out, graze_context *context,
                                 const graze_envelope *envelope, unsigned long seed,
                                 unsigned long index) {
    int found = 0;
    PUBLIC_OUT(out, context, envelope);
    graze_site *made = malloc(sizeof *made);
    graze_status status = made ? sample_make(made, &found, context, envelope, seed, index)
                               : context_fail(context, GRAZE_ESYSTEM, "out of memory");
    if (found)
        *out = made;
    else
        free(made);
    return status;
}
