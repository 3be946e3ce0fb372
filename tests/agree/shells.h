/* Reading shells of a solid into a Nef polyhedron, exactly, for the CGAL side of the agreement
 * tests. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Input, in tokens: `shell +` (a part) or `shell -` (a cavity, given outward oriented too), number
 * of vertices and facets, coordinates as ratios, facets as a count and that many indices; any
 * number of shells, parts before the cavities cut out of them. Each shell is a closed 2-manifold by
 * itself: CGAL fills cavities and refuses non-manifold edges when it is given all at once.
 */
#ifndef GRAZE_TESTS_AGREE_SHELLS_H
#define GRAZE_TESTS_AGREE_SHELLS_H

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <istream>
#include <stdexcept>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact = Kernel::Exact_kernel::FT;
using Point = Kernel::Point_3;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;

inline std::string next_token(std::istream &in) {
    std::string token;
    if (!(in >> token)) {
        throw std::runtime_error("input ends early");
    }
    return token;
}

inline size_t next_count(std::istream &in) {
    return std::stoul(next_token(in));
}

inline Point next_point(std::istream &in) {
    Exact x(next_token(in)), y(next_token(in)), z(next_token(in));
    return Point(Kernel::FT(x), Kernel::FT(y), Kernel::FT(z));
}

struct ShellBuilder : CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
    std::vector<Point> points;
    std::vector<std::vector<size_t>> facets;

    explicit ShellBuilder(std::istream &in) {
        size_t vertex_count = next_count(in), facet_count = next_count(in);
        for (size_t k = 0; k < vertex_count; k++) {
            points.push_back(next_point(in));
        }
        facets.resize(facet_count);
        for (auto &facet : facets) {
            facet.resize(next_count(in));
            for (auto &index : facet) {
                index = next_count(in);
            }
        }
    }

    void operator()(Polyhedron::HalfedgeDS &hds) override {
        CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> builder(hds, true);
        builder.begin_surface(points.size(), facets.size());
        for (const auto &point : points) {
            builder.add_vertex(point);
        }
        for (const auto &facet : facets) {
            builder.add_facet(facet.begin(), facet.end());
        }
        builder.end_surface();
    }
};

/** The solid of all shells up to the token `end`, regular closed. */
inline Nef read_solid(std::istream &in) {
    Nef solid(Nef::EMPTY);
    for (std::string word = next_token(in); word != "end"; word = next_token(in)) {
        std::string sign = next_token(in);
        ShellBuilder builder(in);
        Polyhedron surface;
        surface.delegate(builder);
        if (word != "shell" || !surface.is_valid() || !surface.is_closed()) {
            throw std::runtime_error("not a closed shell");
        }
        Nef part(surface);
        solid = sign == "-" ? solid - part : solid + part;
    }
    return solid.regularization();
}

#endif
