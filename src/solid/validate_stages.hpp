/* The stages of the validation, and what they hand to one another.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Theorem. Let the pieces be triangles (E^2: segments) such that (1) the relative interiors of
 * different pieces are disjoint, (2) every edge, by positions, is run through as often one way as
 * the other, and (3) along every segment (E^2: at every point) where the sides of more than two
 * pieces come together, edge with edge or edge with the inside of a piece, the germs of the pieces
 * sorted around it alternate between in->out and out->in. Then the signed winding number w rises by
 * one across every piece from its outer to its inner side, and its value on the outer side is the
 * same for all pieces of one component, components being joined by common edges and by those
 * contacts (E^2: by vertices and contact points).
 *
 * Proof. By (2) the pieces form a cycle, so w is defined off the boundary and locally constant; by
 * (1) a point inside a piece that is in no other piece has just this one layer around it, so w
 * rises by one there. Around an interior point of an elementary segment the germs cut a small disc
 * across it into sectors; w changes by one at each, by (3) alternately down and up, so every germ
 * has the same value outside and the same value inside. The inside of a piece, less the elementary
 * segments in it, less finitely many points, falls into parts that are joined across those
 * segments, where both halves of the piece are among the germs; points do not disconnect it. So the
 * outer value is one number for a piece, and one for a component. With two germs, (2) is (3).
 *
 * It follows that one side test per component, outer value 0, decides everything: then w is 0 or 1
 * everywhere, the solid is the closure of w = 1, and its boundary is the union of the pieces. In
 * E^3 contacts in isolated points need no look. Diagonals, made by cutting facets, are edges here.
 * With proofs: proofs/claims.md C2, C3 and C4; C5 says that nothing legal is refused.
 */
#ifndef GRAZE_SOLID_VALIDATE_STAGES_HPP
#define GRAZE_SOLID_VALIDATE_STAGES_HPP

#include <numeric>
#include "solid/failure.hpp"
#include "solid/validate_germs.hpp"
#include "solid/validate_pairs.hpp"

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

/** Number the sets the pieces are in, in the order of their first pieces, and tell every piece.
 * @return the number of sets */
std::size_t assign_components(std::vector<piece> &pieces, disjoint_sets &sets);

/** Check the facets of a soup in E^3 one by one and cut them into triangles. */
std::vector<piece> cut_facets(graze_context *context, const points &at, const soup &s, bool fan);

/** Cut one planar facet that is no triangle, appending its triangles. `plane` holds three positions
 * that are not collinear, with their drop and facing. */
void cut_planar_facet(graze_context *context, std::vector<piece> &out, const points &at,
                      const soup &s, std::size_t facet, const piece &plane);

/** Check how the triangles of a boundary come together, and number their components. With
 * `trust_contacts` only the balance of edges is looked at: (1) and (3) are known, and components
 * are joined by common edges alone, which makes them no larger, so the theorem holds for them too.
 * @return the number of components */
std::size_t check_surface(graze_context *context, std::vector<piece> &pieces, const points &at,
                          bool trust_contacts);

/** The edges of a soup in E^2 that have a length, ring by ring. */
std::vector<piece> cut_rings(const points &at, const soup &s);

/** Check how the edges of polygons come together, and number their components.
 * @return the number of components */
std::size_t check_outline(graze_context *context, std::vector<piece> &pieces, const points &at,
                          const soup &s);

/** The input's names of cells that the pieces, those of a facet together, do not have. */
void name_cells(cell_names *out, const points &at, const soup &s, const std::vector<piece> &pieces);

#endif
