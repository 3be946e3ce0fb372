/* Components of a boundary: pieces joined by common edges and contacts.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_COMPONENTS_HPP
#define GRAZE_VALIDATE_COMPONENTS_HPP

#include <numeric>
#include "input/validate/pairs.hpp"

/** Sets that only ever merge. */
class disjoint_sets {
  public:
    explicit disjoint_sets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }
    std::uint32_t find(std::uint32_t x) {
        while (parent_[x] != x)
            x = parent_[x] = parent_[parent_[x]];
        return x;
    }
    void join(std::uint32_t x, std::uint32_t y) {
        parent_[find(x)] = find(y);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

/** Number the sets of pieces in the order of their first pieces, and record the number in every
 * piece.
 * @return the number of sets */
std::size_t assign_components(std::vector<piece> &pieces, disjoint_sets &sets);

#endif
