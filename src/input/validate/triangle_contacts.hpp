/* Contacts between the triangles of a boundary in E^3.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_TRIANGLE_CONTACTS_HPP
#define GRAZE_VALIDATE_TRIANGLE_CONTACTS_HPP

#include "input/validate/pairs.hpp"

/** Check the contacts between the triangles of a boundary, and number their components. With
 * `trust_contacts` only the balance of edges is looked at: (1) and (3) are known, and components
 * are joined by common edges alone, which makes them no larger, so the theorem holds for them too.
 * @return the number of components */
std::size_t check_surface(graze_context *context, std::vector<piece> &pieces, const points &at,
                          bool trust_contacts);

#endif
