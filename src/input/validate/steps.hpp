/* The steps from a soup to simplices, each in a source of its own, and sets of joined pieces.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_STEPS_HPP
#define GRAZE_VALIDATE_STEPS_HPP

#include <numeric>
#include "input/validate/pairs.hpp"

/** Refuse a soup whose vertices, cells, or the three sides of every cell, 32 bits cannot count. */
void check_size(graze_context *context, const soup &s);

/** Copy the cells of pieces and the number of components to `out`, in memory of malloc. */
void hand_over(simplices *out, const std::vector<piece> &pieces, std::size_t components);

/** Check the facets of a soup in E^3 one by one and cut them into triangles.
 * @param flat NULL: facets without area are refused, and fans with such triangles; else they are
 * left out and counted here */
std::vector<piece> cut_facets(graze_context *context, const points &at, const soup &s, bool fan,
                              std::size_t *flat);

/** Cut one planar facet that is no triangle, appending its triangles. `plane` holds three positions
 * that are not collinear, with their drop and facing. */
void cut_planar_facet(graze_context *context, std::vector<piece> &out, const points &at,
                      const soup &s, std::size_t facet, const piece &plane);

/** The edges of a soup in E^2 that have a length, ring by ring. */
std::vector<piece> cut_rings(const points &at, const soup &s);

/** Check the contacts between the edges of polygons, and number their components.
 * @return the number of components */
std::size_t check_outline(graze_context *context, std::vector<piece> &pieces, const points &at,
                          const soup &s);

/** Check the contacts between the triangles of a boundary, and number their components. With
 * `trust_contacts` only the balance of edges is looked at: (1) and (3) of the theorem in
 * validate.cpp are known, and triangles are joined by common edges alone. Components are then parts
 * of the theorem's components, so it holds for them too.
 * @return the number of components */
std::size_t check_surface(graze_context *context, std::vector<piece> &pieces, const points &at,
                          bool trust_contacts);

/** Find the input's names of cells that the pieces do not have. Pieces of one facet stand together.
 */
void name_cells(cell_names *out, const points &at, const soup &s, const std::vector<piece> &pieces);

/* Components: pieces joined by common edges and contacts. */

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
