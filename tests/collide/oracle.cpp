/* Pairs of solids by CGAL's Nef polyhedra: a sweep along a segment against a solid, and positions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Standard input: the shells of the moving solid and `end`, those of the fixed one and `end` (both
 * agree/shells.h); the number of segments, 0 or 1, and its two end points, between which the origin
 * is carried; the number of positions, each 12 ratios, the rows of a map with a positive
 * determinant. Standard output: for the segment one letter, then one a position. I: the interiors
 * meet, at some time; B: the closed sets do; O: neither.
 */
#include "../agree/legs.h"
#include <CGAL/Aff_transformation_3.h>
#include <iostream>

namespace {

/* int S + segment is the union of all positions of the interior: what meets at both sides of a
 * position alone, without its interior, is no part of it. */
char along(const Nef &moving, const Nef &fixed, const Nef &leg) {
    if (!(sum(moving.interior(), leg) * fixed.interior()).is_empty())
        return 'I';
    return (sum(moving, leg) * fixed).is_empty() ? 'O' : 'B';
}

/* Both are the closures of their interiors, so that the interior of what they share is what their
 * interiors share. */
char at(Nef moving, const Nef &fixed, const CGAL::Aff_transformation_3<Kernel> &map) {
    moving.transform(map);
    Nef shared = moving * fixed;
    return shared.is_empty() ? 'O' : shared.interior().is_empty() ? 'B' : 'I';
}

CGAL::Aff_transformation_3<Kernel> next_map(std::istream &in) {
    Kernel::FT m[12];
    for (auto &entry : m)
        entry = Kernel::FT(Exact(next_token(in)));
    return {m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[9], m[10], m[11]};
}

void run(std::istream &in, std::ostream &out) {
    Nef moving = read_solid(in), fixed = read_solid(in);
    for (size_t k = next_count(in); k > 0; k--) {
        Point from = next_point(in), to = next_point(in);
        out << along(moving, fixed, segment(from, to)) << '\n';
    }
    for (size_t k = next_count(in); k > 0; k--)
        out << at(moving, fixed, next_map(in)) << '\n';
}

} // namespace

int main() {
    try {
        for (std::string word; std::cin >> word;) {
            if (word != "pair")
                throw std::runtime_error("expected a pair");
            run(std::cin, std::cout);
        }
    } catch (const std::exception &error) {
        std::cerr << "oracle: " << error.what() << "\n";
        return 1;
    }
    return std::cout.flush() ? 0 : 1;
}
