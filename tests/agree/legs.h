/* Sweeps along straight legs as Minkowski sums, for the CGAL side of the tests.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TESTS_AGREE_LEGS_H
#define GRAZE_TESTS_AGREE_LEGS_H

#include "shells.h"
#include <CGAL/minkowski_sum_3.h>
#include <list>
#include <utility>

inline Nef segment(const Point &from, const Point &to) {
    std::vector<Point> points{from, to};
    using Range = std::pair<std::vector<Point>::iterator, std::vector<Point>::iterator>;
    std::list<Range> lines{{points.begin(), points.end()}};
    return Nef(lines.begin(), lines.end(), Nef::Polylines_tag());
}

/* minkowski_sum_3 cuts its arguments into convex parts in place, hence by value. */
inline Nef sum(Nef solid, Nef leg) {
    return CGAL::minkowski_sum_3(solid, leg);
}

#endif
