/* The door to the validation: a soup in, oriented simplices with components out (validate.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <cstdlib>
#include <limits>
#include "solid/cgal.h"
#include <CGAL/version.h>
#include "solid/validate_stages.hpp"

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

namespace {

/* Vertices, cells and the three sides of every cell are counted in 32 bits. */
void check_size(graze_context *context, const soup &s) {
    constexpr std::size_t MOST = std::numeric_limits<std::uint32_t>::max() / 8;
    if (s.vertex_count > MOST || s.index_count > MOST || s.facet_count > MOST)
        throw failure{context_fail(context, GRAZE_ELIMIT,
                                   "the solid has more than %zu vertices or corners of facets, "
                                   "which is as many as can be numbered",
                                   MOST)};
}

flat_sides find_flat(const points &at, const soup &s) {
    flat_sides flat = {};
    for (std::size_t f = 0; f < s.facet_count; f++)
        for (std::size_t c = s.facet_start[f]; c < s.facet_start[f + 1]; c++)
            for (std::size_t k = s.cycle_start[c]; k < s.cycle_start[c + 1]; k++) {
                const std::size_t next = k + 1 < s.cycle_start[c + 1] ? k + 1 : s.cycle_start[c];
                const std::uint32_t from = s.index[k], to = s.index[next];
                if (at.position(from) == at.position(to) && flat.count++ == 0)
                    flat = {1, f, c - s.facet_start[f], from, to};
            }
    return flat;
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

} // namespace

graze_status validate_soup(simplices *out, graze_context *context, const soup *s, unsigned flags) {
    *out = {};
    return guard(context, [&] {
        check_size(context, *s);
        const points at(s->dimension, s->vertex_count, s->coordinates);
        std::vector<piece> pieces;
        std::size_t components = 0;
        if (s->dimension == 2) {
            pieces = cut_rings(at, *s);
            components = check_outline(context, pieces, at, *s);
        } else {
            pieces = cut_facets(context, at, *s, (flags & GRAZE_SOLID_TRIANGULATE) != 0);
            components = check_surface(context, pieces, at, (flags & VALIDATE_TRUST_CONTACTS) != 0);
        }
        hand_over(out, pieces, components);
        name_cells(&out->names, at, *s, pieces);
        out->flat = find_flat(at, *s);
    });
}

void simplices_clear(simplices *cut) {
    std::free(cut->item);
    cell_names_clear(&cut->names);
    *cut = {};
}

graze_status validate_probe(graze_context *context) {
    return guard(context, [] { CGAL_precondition_msg(false, "failed on purpose"); });
}

const char *validate_cgal_version(void) {
    return CGAL_VERSION_STR;
}
