/* graze/certify.h - certificates of answers, which graze-check verifies.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A certificate is its head, one row for each point, and a line `complete N` with the number of
 * rows (proofs/certificate.md).
 */
#ifndef GRAZE_CERTIFY_H
#define GRAZE_CERTIFY_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Source of the certificates of one scene. It never changes: threads may share it. */
typedef struct graze_certifier graze_certifier;

/**
 * Make a certifier of a scene. Solid and motion must come from files, in E^3 an .off and in E^2 a
 * .wkt, without rounding: graze-check reads no others (graze_solid_text writes one). The scene is
 * borrowed and must outlive the certifier.
 * @param flags those of the call that read the solid
 * @return GRAZE_EUSE a NULL handle, a rounding, flags, or a scene not read from files;
 * GRAZE_EILLEGAL a facet that is not the fan of its first corner; GRAZE_ELIMIT
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

#ifdef __cplusplus
}
#endif
#endif
