/* Input and output of the validation, in C's types.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_PIECES_OUT_HPP
#define GRAZE_VALIDATE_PIECES_OUT_HPP

#include "base/context/context.h"
#include "input/validate/pairs.hpp"

/** Refuse a soup whose vertices, cells, or the three sides of every cell, 32 bits cannot count. */
void check_size(graze_context *context, const soup &s);

/** Put pieces where C finds them. */
void hand_over(simplices *out, const std::vector<piece> &pieces, std::size_t components);

#endif
