/* Pairs of boxes that intersect: candidates for the exact tests. Boxes are made of the ranks of
 * coordinates (points.hpp), so that even they are exact. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_BOXES_HPP
#define GRAZE_VALIDATE_BOXES_HPP

#include <algorithm>
#include <cstdint>
#include <vector>
#include <CGAL/box_intersection_d.h>
#include "input/validate/failure.hpp"
#include "input/validate/pairs.hpp"

/** A list of closed boxes, each with a number. A third axis is 0 in E^2. */
class box_list {
  public:
    explicit box_list(std::size_t capacity) {
        boxes_.reserve(capacity);
    }

    /** Add the box of `count` points, with a number. */
    void add(const points &at, std::uint32_t number, const std::uint32_t *point, int count) {
        double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
        for (int j = 0; j < at.dimension(); j++) {
            low[j] = high[j] = at.rank(point[0], j);
            for (int k = 1; k < count; k++) {
                low[j] = std::min(low[j], double(at.rank(point[k], j)));
                high[j] = std::max(high[j], double(at.rank(point[k], j)));
            }
        }
        boxes_.emplace_back(CGAL::Bbox_3(low[0], low[1], low[2], high[0], high[1], high[2]),
                            number);
    }

    /** Call visit(i, j) for the numbers of any two intersecting boxes, once. */
    template <class Visit> void each_pair(const Visit &visit) {
        std::vector<const box *> all = addresses();
        CGAL::box_self_intersection_d(all.begin(), all.end(), [&](const box *a, const box *b) {
            visit(a->info(), b->info());
        });
    }

    /** Call visit(i, j) for box i of this list and box j of the other where they intersect. */
    template <class Visit> void each_pair(const box_list &other, const Visit &visit) {
        std::vector<const box *> mine = addresses(), theirs = other.addresses();
        CGAL::box_intersection_d(mine.begin(), mine.end(), theirs.begin(), theirs.end(),
                                 [&](const box *a, const box *b) { visit(a->info(), b->info()); });
    }

  private:
    typedef CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t,
                                                      CGAL::Box_intersection_d::ID_FROM_BOX_ADDRESS>
        box;

    std::vector<const box *> addresses() const {
        std::vector<const box *> all;
        all.reserve(boxes_.size());
        for (const box &b : boxes_)
            all.push_back(&b);
        return all;
    }

    std::vector<box> boxes_;
};

/** Call visit(i, j), i < j, for any two of some pieces whose boxes intersect, once. */
template <class Visit>
void each_candidate(graze_context *context, const points &at, const std::vector<piece> &pieces,
                    const Visit &visit) {
    box_list boxes(pieces.size());
    for (std::uint32_t i = 0; i < pieces.size(); i++)
        boxes.add(at, i, pieces[i].at, at.dimension());
    interruption cancel(context);
    boxes.each_pair([&](std::uint32_t i, std::uint32_t j) {
        cancel.poll();
        visit(std::min(i, j), std::max(i, j));
    });
}

#endif
