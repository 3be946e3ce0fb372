/* Components are numbered in the order of their first pieces.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/validate/components.hpp"

#include <limits>

std::size_t assign_components(std::vector<piece> &pieces, disjoint_sets &sets) {
    constexpr std::uint32_t NONE = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(pieces.size(), NONE);
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < pieces.size(); i++) {
        std::uint32_t &mine = number[sets.find(i)];
        if (mine == NONE)
            mine = count++;
        pieces[i].cell.component = mine;
    }
    return count;
}
