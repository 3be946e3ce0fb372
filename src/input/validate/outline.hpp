/* Contacts between the edges of polygons in E^2.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_OUTLINE_HPP
#define GRAZE_VALIDATE_OUTLINE_HPP

#include "input/validate/pairs.hpp"

/** The edges of a soup in E^2 that have a length, ring by ring. */
std::vector<piece> cut_rings(const points &at, const soup &s);

/** Check the contacts between the edges of polygons, and number their components.
 * @return the number of components */
std::size_t check_outline(graze_context *context, std::vector<piece> &pieces, const points &at,
                          const soup &s);

#endif
