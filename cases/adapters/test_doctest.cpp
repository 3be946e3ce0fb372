/* Exact answers in doctest. SPDX-License-Identifier: CC0-1.0
 *
 *     c++ -std=c++17 test_doctest.cpp $(pkg-config --cflags --libs graze) -o mine && ./mine
 */
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <graze/testing.hpp>

#include "mine.hpp"

TEST_CASE("points that a moving cube sweeps") {
    const graze::scene cube(graze::solid::box({0, 0, 0}, {2, 2, 2}),
                            graze::motion::line({8, 0, 0}));
    for (const auto &row : graze::testing::rows(cube, 300)) {
        CAPTURE(row);
        CHECK(row.accepts(swept(row.point)));
    }
}

TEST_CASE("first contacts of two boxes") {
    const auto moving = graze::solid::box({0, 0, 0}, {1, 1, 1});
    const auto fixed = graze::solid::box({3, 0, 0}, {4, 1, 1});
    for (const std::vector<double> &v :
         {std::vector<double>{4, 0, 0}, {-4, 0, 0}, {4, 1, 0}, {4, 3, 0}, {2, 0.25, -0.5}}) {
        const auto exact = graze::testing::first(moving, graze::motion::line(v), fixed);
        CAPTURE(exact);
        CHECK(exact.accepts(first_time(v), 1e-12));
    }
}
