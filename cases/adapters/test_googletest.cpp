/* Exact answers in GoogleTest: each row is a test of its own. SPDX-License-Identifier: CC0-1.0
 *
 *     c++ -std=c++17 test_googletest.cpp $(pkg-config --cflags --libs graze gtest_main) \
 *         -o mine && ./mine
 */
#include <gtest/gtest.h>

#include <graze/testing.hpp>

#include "mine.hpp"

using graze::testing::row;

static graze::scene cube() {
    return graze::scene(graze::solid::box({0, 0, 0}, {2, 2, 2}), graze::motion::line({8, 0, 0}));
}

class Points : public testing::TestWithParam<row> {};

TEST_P(Points, AreSweptAsTheyShouldBe) {
    EXPECT_TRUE(GetParam().accepts(swept(GetParam().point))) << GetParam();
}

INSTANTIATE_TEST_SUITE_P(Cube, Points, testing::ValuesIn(graze::testing::rows(cube(), 300)));

TEST(Boxes, MeetFirst) {
    for (const std::vector<double> &v :
         {std::vector<double>{4, 0, 0}, {-4, 0, 0}, {4, 1, 0}, {4, 3, 0}, {2, 0.25, -0.5}}) {
        const auto exact =
            graze::testing::first(graze::solid::box({0, 0, 0}, {1, 1, 1}), graze::motion::line(v),
                                  graze::solid::box({3, 0, 0}, {4, 1, 1}));
        EXPECT_TRUE(exact.accepts(first_time(v), 1e-12)) << exact;
    }
}
