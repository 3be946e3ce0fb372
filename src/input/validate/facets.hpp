/* The facets of a soup in E^3, each checked and cut into triangles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_FACETS_HPP
#define GRAZE_VALIDATE_FACETS_HPP

#include "input/validate/pairs.hpp"

/** Check the facets of a soup in E^3 one by one and cut them into triangles.
 * @param flat NULL: facets without area are refused, and fans with such triangles; else they are
 * left out and counted here */
std::vector<piece> cut_facets(graze_context *context, const points &at, const soup &s, bool fan,
                              std::size_t *flat);

#endif
