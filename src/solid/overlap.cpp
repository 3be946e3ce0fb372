/* Does the boundary of a solid touch the boundary of its image under an affine map? (validate.h)
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The vertices and their exact images are put into one set of points, so that the ranks of their
 * coordinates, hence the candidate boxes, are exact for both: boundaries a gap of any size apart
 * along an axis give no candidate at all.
 */
#include "solid/cgal.h"
#include "solid/validate_boxes.hpp"
#include "solid/validate_pairs.hpp"

namespace {

/* Ends the search at the first common point. */
struct met {};

class rationals {
  public:
    explicit rationals(std::size_t count) : value_(count) {
        for (fmpq &x : value_)
            fmpq_init(&x);
    }
    ~rationals() {
        for (fmpq &x : value_)
            fmpq_clear(&x);
    }
    rationals(const rationals &) = delete;
    rationals &operator=(const rationals &) = delete;
    fmpq *operator[](std::size_t i) {
        return &value_[i];
    }

  private:
    std::vector<fmpq> value_;
};

/* The vertices, then their images. */
points with_images(const soup &s, const fmpq *map) {
    const std::size_t d = static_cast<std::size_t>(s.dimension);
    rationals all(2 * d * s.vertex_count);
    for (std::size_t v = 0; v < s.vertex_count; v++) {
        const fmpq *x = s.coordinates + v * d;
        for (std::size_t i = 0; i < d; i++) {
            fmpq_set(all[v * d + i], x + i);
            fmpq *image = all[(s.vertex_count + v) * d + i];
            fmpq_set(image, map + i * (d + 1) + d);
            for (std::size_t j = 0; j < d; j++)
                fmpq_addmul(image, map + i * (d + 1) + j, x + j);
        }
    }
    return points(s.dimension, 2 * s.vertex_count, all[0]);
}

std::vector<piece> pieces_from(const points &at, const simplices &cut, std::size_t shift,
                               box_list &boxes) {
    std::vector<piece> all(cut.count);
    for (std::size_t k = 0; k < cut.count; k++) {
        piece &p = all[k];
        p.cell = cut.item[k];
        for (int m = 0; m < at.dimension(); m++)
            p.at[m] = at.position(static_cast<std::uint32_t>(p.cell.vertex[m] + shift));
        if (at.dimension() == 3)
            piece_orient(p, at);
        boxes.add(at, static_cast<std::uint32_t>(k), p.at, at.dimension());
    }
    return all;
}

} // namespace

graze_status boundaries_meet(int *out, graze_context *context, const soup *s, const simplices *cut,
                             const fmpq *map) {
    *out = 0;
    return guard(context, [&] {
        const points at = with_images(*s, map);
        box_list standing(cut->count), moved(cut->count);
        const std::vector<piece> here = pieces_from(at, *cut, 0, standing);
        const std::vector<piece> there = pieces_from(at, *cut, s->vertex_count, moved);
        interruption cancel(context);
        try {
            standing.each_pair(moved, [&](std::uint32_t i, std::uint32_t j) {
                cancel.poll();
                if (pieces_meet(at, here[i], there[j]))
                    throw met{};
            });
        } catch (const met &) {
            *out = 1;
        }
    });
}
