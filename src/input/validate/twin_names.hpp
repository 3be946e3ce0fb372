/* Names of cells that the pieces do not have (input/soup/soup.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_TWIN_NAMES_HPP
#define GRAZE_VALIDATE_TWIN_NAMES_HPP

#include "input/validate/pairs.hpp"

/** The input's names of cells that the pieces, those of a facet together, do not have. */
void name_cells(cell_names *out, const points &at, const soup &s, const std::vector<piece> &pieces);

#endif
