/* planar: the boundary, as a soup, of a solid of a `.csg.json` file whose surfaces are all planes,
 * in the plane lines. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_PLANAR_H
#define GRAZE_INPUT_PLANAR_H

#include "input/csg/csg.h"
#include "input/soup/soup.h"

/** Whether each surface of a solid is a plane, in the plane a line. */
int flat_surfaces(const csg *solid);

/**
 * Find the facets of a solid whose surfaces are all planes (proofs/curved.md C133).
 * @param[out] out facets with their holes, outward oriented; without facets where *form is not
 * CSG_FACETS. Cleared by soup_clear, also after a failure
 * @return GRAZE_ELIMIT `work`, `cells`; GRAZE_ECANCELED; GRAZE_ESYSTEM
 */
graze_status planar_soup(soup *out, csg_form *form, graze_context *context, const csg *solid);

#endif
