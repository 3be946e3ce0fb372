/* graze/certify.h - certificates of answers.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CERTIFY_H
#define GRAZE_CERTIFY_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What certificates of a scene are made with (proofs/certificate.md). */
typedef struct graze_certifier graze_certifier;

/**
 * Make a certifier of a scene whose solid and motion were read from files, in E^3 an .off and in
 * E^2 a .wkt, without rounding: graze-check reads no others (graze_solid_text writes one). The
 * scene is borrowed and must outlive it. Threads may share it.
 * @param flags those the solid was read with
 * @return GRAZE_EUSE a NULL handle, a rounding, flags, or a scene that was not read from files;
 * GRAZE_EILLEGAL a facet that is not the fan of its first corner; GRAZE_ELIMIT
 */
GRAZE_API GRAZE_CHECKED graze_status graze_certifier_create(graze_certifier **out,
                                                            graze_context *context,
                                                            const graze_scene *scene,
                                                            unsigned flags);
/** Free a certifier. NULL is harmless. */
GRAZE_API void graze_certifier_destroy(graze_certifier *certifier);
/**
 * The head of a certificate; the rows follow, then a line `complete N` with their number.
 * @param[out] out text for graze_free; NULL on failure
 */
GRAZE_API GRAZE_CHECKED graze_status graze_certificate_head(char **out, graze_context *context,
                                                            const graze_certifier *certifier);
/**
 * The lines that certify the answer for a point: the answer itself, and hints by which graze-check
 * proves it.
 * @param[out] out text for graze_free; NULL on failure
 * @param point d canonical rationals
 * @return GRAZE_EUSE, GRAZE_ELIMIT, GRAZE_ECANCELED
 */
GRAZE_API GRAZE_CHECKED graze_status graze_certificate_row(char **out, graze_context *context,
                                                           const graze_certifier *certifier,
                                                           const mpq_t *point);

#ifdef __cplusplus
}
#endif
#endif
