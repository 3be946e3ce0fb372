/* The first-order role of a site.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTACT_ROLE_H
#define GRAZE_CONTACT_ROLE_H

#include "questions/contact/site_record.h"

/**
 * The role of a site with its place, sides, germs and points (proofs/envelope.md C60).
 * @return GRAZE_ELIMIT too many planes border what is covered; as cone_state
 */
graze_status role_decide(graze_role *out, graze_context *context, const graze_site *site);

#endif
