/* Certificates of answers (proofs/certificate.md): the hints that a checker follows.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CERTIFY_CERTIFY_H
#define GRAZE_CERTIFY_CERTIFY_H

#include "number/text.h"
#include "scene/scene.h"

/** What rows are certified with; only read, so that threads may share it. */
typedef struct certifier {
    const graze_scene *scene; /* borrowed */
    const graze_solid *solid; /* the scene's own, or `cut` */
    graze_solid *cut;         /* its facets cut into triangles as the checker cuts them; or NULL */
    int triangulated;
} certifier;

/**
 * @param flags those the solid was read with
 * @return GRAZE_EUSE the scene was not read from files, or under a rounding; GRAZE_EILLEGAL,
 * GRAZE_ELIMIT: the solid, once cut
 */
graze_status certifier_make(certifier *out, graze_context *context, const graze_scene *scene,
                            unsigned flags);
void certifier_clear(certifier *c);

/** The certificate's head. */
graze_status certify_head(text *out, graze_context *context, const certifier *c);
/** The lines of one row. */
graze_status certify_row(text *out, graze_context *context, const certifier *c, const fmpq *point);

/** The solid with every facet of more than three corners cut as the checker cuts it; *out is NULL
 * where there is none. */
graze_status certify_cut(graze_solid **out, graze_context *context, const graze_solid *solid,
                         unsigned flags);

#endif
