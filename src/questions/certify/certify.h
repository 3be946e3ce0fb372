/* certify: makes certificates, whose hints let `graze-check` prove rows.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_CERTIFY_H
#define GRAZE_QUESTIONS_CERTIFY_H

#include "base/number/text.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "graze/certify.h"
#include "input/solid/solid.h"

/* Data for making certificates, and their head (proofs/certificate.md). */

/** Data for certifying rows; read only, so that threads may share it. */
typedef struct certifier {
    const graze_scene *scene; /* borrowed */
    const graze_solid *solid; /* the scene's own, or `cut` */
    graze_solid *cut;         /* its facets cut into triangles as the checker cuts them; or NULL */
    int with_contacts;        /* rows give the times and cells of contacts */
} certifier;

/**
 * @param flags the flags with which the solid was read, and GRAZE_CERTIFY_TIMES
 * @return GRAZE_EUSE the scene was not read from files, numbers are rounded, or the solid was
 * triangulated; GRAZE_EILLEGAL, GRAZE_ELIMIT: `cut` is not legal, or too large
 */
graze_status certifier_make(certifier *out, graze_context *context, const graze_scene *scene,
                            unsigned flags);
void certifier_clear(certifier *c);

/** Write the certificate's head. */
graze_status certify_head(text *out, graze_context *context, const certifier *c);

/* The certificate of one row (proofs/certificate.md). */

/** Write the lines of one row; `trace` is the trace of its point, with times and cells of contacts
 * if the certificate has contacts. */
graze_status certify_row(text *out, graze_context *context, const certifier *c, const fmpq *point,
                         const graze_trace *trace);

#endif
