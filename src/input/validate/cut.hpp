/* A planar facet cut into triangles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_CUT_HPP
#define GRAZE_VALIDATE_CUT_HPP

#include "input/validate/pairs.hpp"

/** Cut one planar facet that is no triangle, appending its triangles. `plane` holds three positions
 * that are not collinear, with their drop and facing. */
void cut_planar_facet(graze_context *context, std::vector<piece> &out, const points &at,
                      const soup &s, std::size_t facet, const piece &plane);

#endif
