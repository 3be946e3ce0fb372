/* Exact answers in Catch2, 3 or 2. SPDX-License-Identifier: CC0-1.0
 *
 * Catch2 2, one header (Debian 12):
 *     c++ -std=c++17 test_catch2.cpp $(pkg-config --cflags --libs graze) -o mine && ./mine
 * Catch2 3: add $(pkg-config --cflags --libs catch2-with-main), or -IFOLDER
 * FOLDER/catch_amalgamated.cpp of its folder extras
 */
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#elif __has_include(<catch_amalgamated.hpp>)
#include <catch_amalgamated.hpp>
#else
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
#endif

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
    const auto v = GENERATE(values<std::vector<double>>(
        {{4, 0, 0}, {-4, 0, 0}, {4, 1, 0}, {4, 3, 0}, {2, 0.25, -0.5}}));
    const auto exact =
        graze::testing::first(graze::solid::box({0, 0, 0}, {1, 1, 1}), graze::motion::line(v),
                              graze::solid::box({3, 0, 0}, {4, 1, 1}));
    CAPTURE(exact);
    CHECK(exact.accepts(first_time(v), 1e-12));
}
