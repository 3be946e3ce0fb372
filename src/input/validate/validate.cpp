/* The validation from a soup to oriented simplices with components (validate.h).
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
 * Proofs: proofs/claims.md C2, C3, C4 and C7; C5 says that nothing legal is refused.
 */

#include <CGAL/version.h>
#include "input/validate/cgal.hpp"
#include "input/validate/steps.hpp"

namespace {

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
            pieces = cut_facets(context, at, *s, (flags & GRAZE_SOLID_TRIANGULATE) != 0, nullptr);
            components = check_surface(context, pieces, at, (flags & VALIDATE_TRUST_CONTACTS) != 0);
        }
        hand_over(out, pieces, components);
        name_cells(&out->names, at, *s, pieces);
        out->flat = find_flat(at, *s);
    });
}

graze_status validate_probe(graze_context *context) {
    return guard(context, [] { CGAL_precondition_msg(false, "failed on purpose"); });
}

const char *validate_cgal_version(void) {
    return CGAL_VERSION_STR;
}
