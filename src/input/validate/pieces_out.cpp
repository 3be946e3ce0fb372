/* Sizes of soups, numbers of components, and simplices in memory of C.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/validate/steps.hpp"

#include <cstdlib>
#include <limits>
#include <new>
#include "input/validate/failure.hpp"

void check_size(graze_context *context, const soup &s) {
    constexpr std::size_t MOST = std::numeric_limits<std::uint32_t>::max() / 8;
    if (s.vertex_count > MOST || s.index_count > MOST || s.facet_count > MOST)
        throw failure{context_fail(context, GRAZE_ELIMIT,
                                   "the solid has more than %zu vertices or corners of facets, "
                                   "which is as many as can be numbered",
                                   MOST)};
}

void hand_over(simplices *out, const std::vector<piece> &pieces, std::size_t components) {
    out->item = static_cast<simplex *>(std::malloc((pieces.size() + 1) * sizeof *out->item));
    if (out->item == nullptr)
        throw std::bad_alloc();
    for (std::size_t k = 0; k < pieces.size(); k++)
        out->item[k] = pieces[k].cell;
    out->count = pieces.size();
    out->component_count = components;
}

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

void simplices_clear(simplices *cut) {
    std::free(cut->item);
    cell_names_clear(&cut->names);
    *cut = {};
}
