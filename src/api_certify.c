/* The public functions of certificates.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include "api.h"
#include "certify/head.h"
#include "certify/row.h"
#include "context/environment.h"

struct graze_certifier {
    certifier inner;
};

graze_status graze_certifier_create(graze_certifier **out, graze_context *context,
                                    const graze_scene *scene, unsigned flags) {
    if (out)
        *out = NULL;
    if (!out || !context || !scene)
        return api_misuse(context, "graze_certifier_create",
                          "out, context and scene must not be NULL");
    if (flags & ~GRAZE_SOLID_TRIANGULATE)
        return api_misuse(context, "graze_certifier_create", "a flag is unknown");
    __attribute__((cleanup(environment_leave), unused)) environment host = environment_enter();
    graze_certifier *made = malloc(sizeof *made);
    if (!made)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory");
    graze_status status = certifier_make(&made->inner, context, scene, flags);
    if (status)
        free(made);
    else
        *out = made;
    return status;
}

void graze_certifier_destroy(graze_certifier *certifier) {
    if (!certifier)
        return;
    certifier_clear(&certifier->inner);
    free(certifier);
}

graze_status graze_certificate_head(char **out, graze_context *context,
                                    const graze_certifier *certifier) {
    if (out)
        *out = NULL;
    if (!out || !context || !certifier)
        return api_misuse(context, "graze_certificate_head",
                          "out, context and certifier must not be NULL");
    __attribute__((cleanup(environment_leave), unused)) environment host = environment_enter();
    text t;
    text_init(&t);
    graze_status status = certify_head(&t, context, &certifier->inner);
    if (!status)
        return text_finish(out, context, &t);
    text_clear(&t);
    return status;
}

graze_status graze_certificate_row(char **out, graze_context *context,
                                   const graze_certifier *certifier, graze_rationals point) {
    if (out)
        *out = NULL;
    if (!out || !context || !certifier || !point)
        return api_misuse(context, "graze_certificate_row",
                          "out, context, certifier and point must not be NULL");
    __attribute__((cleanup(environment_leave), unused)) environment host = environment_enter();
    int d = certifier->inner.scene->motion->dimension;
    fmpq *p = _fmpq_vec_init(d);
    graze_status status = api_point(p, context, certifier->inner.scene, point);
    text t;
    text_init(&t);
    if (!status)
        status = certify_row(&t, context, &certifier->inner, p);
    _fmpq_vec_clear(p, d);
    if (!status)
        return text_finish(out, context, &t);
    text_clear(&t);
    return status;
}
