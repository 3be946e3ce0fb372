/* Tables of signs. SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>
#include "base/context/scope.h"
#include "questions/envelope/sign_events.h"

void signs_init(signs *s, size_t count, size_t rooted) {
    memset(s, 0, sizeof *s);
    s->count = count;
    s->rooted = rooted;
    s->p = flint_malloc((count + 1) * sizeof *s->p);
    for (size_t p = 0; p < count; p++)
        fmpz_poly_init(&s->p[p]);
}

void signs_clear(signs *s) {
    for (size_t p = 0; p < s->count; p++)
        fmpz_poly_clear(&s->p[p]);
    flint_free(s->p);
    axis_clear(&s->x);
    free(s->at);
    free(s->before);
}

graze_status signs_find(signs *s, graze_context *context) {
    TRY(axis_make(&s->x, context, s->p, s->rooted));
    s->at = calloc(s->x.count, s->count);
    s->before = calloc(s->x.count, s->count);
    if (!s->at || !s->before)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for signs");
    for (size_t k = 0; k < s->x.count; k++)
        for (size_t p = 0; p < s->count; p++) {
            int sign = 0;
            TRY(axis_sign(&sign, context, &s->x, &s->p[p], k));
            s->at[k * s->count + p] = (signed char)sign;
            if (k > 0)
                s->before[k * s->count + p] = (signed char)axis_sign_before(&s->x, &s->p[p], k);
        }
    return GRAZE_OK;
}

const signed char *signs_at(const signs *s, size_t k) {
    return s->at + k * s->count;
}

const signed char *signs_before(const signs *s, size_t k) {
    return s->before + k * s->count;
}
