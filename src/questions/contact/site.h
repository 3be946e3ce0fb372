/* A site: a boundary point y of the solid at a rational time t, and what it is for the envelope.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTACT_SITE_H
#define GRAZE_CONTACT_SITE_H

#include "questions/contact/site_record.h"

/**
 * Make a site (proofs/envelope.md C59 to C63).
 * @param[out] out uninitialised; site_clear after GRAZE_OK
 * @param y d rationals
 * @return GRAZE_EINPUT t is not a time of the motion, or y is not on the boundary; GRAZE_ELIMIT;
 * GRAZE_ECANCELED; GRAZE_ESYSTEM; GRAZE_EINTERNAL
 */
graze_status site_make(graze_site *out, graze_context *context, const graze_scene *scene,
                       const fmpq_t t, const fmpq *y);
/** Parts of a site that a caller asks for: all; its role; trim, orientation and the states beside
 * t. */
typedef enum site_question { SITE_ALL, SITE_ROLE, SITE_TRIM } site_question;

/** site_make for a part: of the others only place, sides, germs and the point in the world are
 * made. site_clear after GRAZE_OK. */
graze_status site_make_for(graze_site *out, graze_context *context, const graze_scene *scene,
                           const fmpq_t t, const fmpq *y, site_question asked);

/**
 * Make the site at the point of a cell's contact set that is nearest to y (proofs/snap.md C75).
 * @param[out] out uninitialised; site_clear after GRAZE_OK; `missed` where the set is empty
 * @return as site_make and snap_find; y need not be on the boundary
 */
graze_status site_snap(graze_site *out, graze_context *context, const graze_scene *scene,
                       const fmpq_t t, const fmpq *y, const graze_cell *cell);
/** Carry a point P of d rationals to M(t)^-1 P, in place. GRAZE_EINPUT: t is not a time of the
 * motion. */
graze_status site_to_body(fmpq *point, graze_context *context, const graze_scene *scene,
                          const fmpq_t t);

void site_clear(graze_site *site);

#endif
