/* Facets cut as the checker of certificates cuts them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CERTIFY_CHECKER_CUT_H
#define GRAZE_CERTIFY_CHECKER_CUT_H

#include "input/solid/solid.h"

/** The solid with every facet of more than three corners cut into the fan of its first one; *out is
 * NULL where there is none. GRAZE_EILLEGAL where a fan is not the facet. */
graze_status certify_cut(graze_solid **out, graze_context *context, const graze_solid *solid);

#endif
