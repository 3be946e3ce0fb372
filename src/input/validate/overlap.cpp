/* Does the boundary of a solid touch the boundary of its image under an affine map? (validate.h)
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Only simplices that reach into the box around the other boundary can meet it. Their vertices, and
 * the exact images of those that move, are put into one set of points, so that the ranks of their
 * coordinates, hence the candidate boxes, are exact for both: boundaries a gap of any size apart
 * along an axis give no candidate at all.
 */
#include "input/validate/boxes.hpp"

#include <flint/fmpq_mat.h>
#include "input/validate/cgal.hpp"

namespace {

/* Thrown to end the search at the first common point. */
struct met {};

/* Rationals, d for a point, that are cleared in the end. */
class rationals {
  public:
    rationals() = default;
    ~rationals() {
        for (fmpq &x : value_)
            fmpq_clear(&x);
    }
    rationals(const rationals &) = delete;
    rationals &operator=(const rationals &) = delete;
    /* Append `count` zeros; pointers of earlier calls become invalid. */
    fmpq *append(std::size_t count) {
        const std::size_t first = value_.size();
        value_.resize(first + count);
        for (std::size_t k = first; k < value_.size(); k++)
            fmpq_init(&value_[k]);
        return &value_[first];
    }
    const fmpq *data() const {
        return value_.data();
    }

  private:
    std::vector<fmpq> value_;
};

/* Apply a map of d rows of d + 1 entries to a point. */
void apply(fmpq *out, const fmpq *map, const fmpq *x, std::size_t d) {
    for (std::size_t i = 0; i < d; i++) {
        fmpq_set(out + i, map + i * (d + 1) + d);
        for (std::size_t j = 0; j < d; j++)
            fmpq_addmul(out + i, map + i * (d + 1) + j, x + j);
    }
}

void invert(fmpq *out, const fmpq *map, slong d) {
    fmpq_mat_t square;
    fmpq_mat_init(square, d + 1, d + 1);
    for (slong k = 0; k < d * (d + 1); k++)
        fmpq_set(square->entries + k, map + k);
    fmpq_one(fmpq_mat_entry(square, d, d));
    const int invertible = fmpq_mat_inv(square, square);
    for (slong k = 0; k < d * (d + 1); k++)
        fmpq_set(out + k, square->entries + k);
    fmpq_mat_clear(square);
    CGAL_precondition(invertible);
}

/* The smallest closed box around points. */
class box_around {
  public:
    explicit box_around(std::size_t d) : d_(d), low_(corner_.append(2 * d)), high_(low_ + d) {
    }
    void include(const fmpq *x) {
        for (std::size_t i = 0; i < d_; i++) {
            if (empty_ || fmpq_cmp(x + i, low_ + i) < 0)
                fmpq_set(low_ + i, x + i);
            if (empty_ || fmpq_cmp(x + i, high_ + i) > 0)
                fmpq_set(high_ + i, x + i);
        }
        empty_ = false;
    }
    /* Widen this box until it holds the image of another box. */
    void include_image(const box_around &box, const fmpq *map) {
        rationals place;
        fmpq *x = place.append(2 * d_);
        for (unsigned corner = 0; corner < 1U << d_; corner++) {
            for (std::size_t i = 0; i < d_; i++)
                fmpq_set(x + i, (corner >> i & 1 ? box.high_ : box.low_) + i);
            apply(x + d_, map, x, d_);
            include(x + d_);
        }
    }
    /* Bits of the sides that x is beyond. */
    std::uint8_t beyond(const fmpq *x) const {
        unsigned sides = 0;
        for (std::size_t i = 0; i < d_; i++)
            sides |= (fmpq_cmp(x + i, low_ + i) < 0    ? 1U
                      : fmpq_cmp(x + i, high_ + i) > 0 ? 2U
                                                       : 0U)
                     << 2 * i;
        return static_cast<std::uint8_t>(sides);
    }

  private:
    std::size_t d_;
    rationals corner_;
    fmpq *low_, *high_;
    bool empty_ = true;
};

/* The simplices that no side of the box separates from it. */
std::vector<std::uint32_t> reaching(const box_around &box, const soup &s, const simplices &cut) {
    const std::size_t d = static_cast<std::size_t>(s.dimension);
    std::vector<std::uint8_t> beyond(s.vertex_count);
    for (std::size_t v = 0; v < s.vertex_count; v++)
        beyond[v] = box.beyond(s.coordinates + v * d);
    std::vector<std::uint32_t> found;
    for (std::uint32_t k = 0; k < cut.count; k++) {
        unsigned common = ~0U;
        for (std::size_t m = 0; m < d; m++)
            common &= beyond[cut.item[k].vertex[m]];
        if (common == 0)
            found.push_back(k);
    }
    return found;
}

/* Simplices as pieces; their vertices, moved where there is a map, are appended to `all`, each
 * once. */
std::vector<piece> collect(rationals &all, std::size_t &count, const soup &s, const simplices &cut,
                           const std::vector<std::uint32_t> &which, const fmpq *map) {
    constexpr std::uint32_t NONE = UINT32_MAX;
    const std::size_t d = static_cast<std::size_t>(s.dimension);
    std::vector<std::uint32_t> number(s.vertex_count, NONE);
    std::vector<piece> pieces(which.size());
    for (std::size_t k = 0; k < which.size(); k++) {
        pieces[k].cell = cut.item[which[k]];
        for (std::size_t m = 0; m < d; m++) {
            const std::uint32_t v = pieces[k].cell.vertex[m];
            if (number[v] == NONE) {
                number[v] = static_cast<std::uint32_t>(count++);
                fmpq *x = all.append(d);
                if (map != nullptr)
                    apply(x, map, s.coordinates + v * d, d);
                else
                    for (std::size_t i = 0; i < d; i++)
                        fmpq_set(x + i, s.coordinates + v * d + i);
            }
            pieces[k].at[m] = number[v];
        }
    }
    return pieces;
}

/* Replace the points of pieces by their positions, orient the pieces in E^3, and add their boxes.
 */
void place(std::vector<piece> &pieces, box_list &boxes, const points &at) {
    for (std::uint32_t k = 0; k < pieces.size(); k++) {
        piece &p = pieces[k];
        for (int m = 0; m < at.dimension(); m++)
            p.at[m] = at.position(p.at[m]);
        if (at.dimension() == 3)
            piece_orient(p, at);
        boxes.add(at, k, p.at, at.dimension());
    }
}

} // namespace

graze_status boundaries_meet(int *out, graze_context *context, const soup *s, const simplices *cut,
                             const fmpq *map) {
    *out = 0;
    return guard(context, [&] {
        const std::size_t d = static_cast<std::size_t>(s->dimension);
        box_around whole(d), moved_whole(d), moved_back(d);
        rationals all, inverse;
        fmpq *back = inverse.append(d * (d + 1));
        invert(back, map, s->dimension);
        for (std::size_t v = 0; v < s->vertex_count; v++)
            whole.include(s->coordinates + v * d);
        moved_whole.include_image(whole, map);
        moved_back.include_image(whole, back);
        std::size_t count = 0;
        std::vector<piece> here =
            collect(all, count, *s, *cut, reaching(moved_whole, *s, *cut), nullptr);
        std::vector<piece> there =
            collect(all, count, *s, *cut, reaching(moved_back, *s, *cut), map);
        if (here.empty() || there.empty())
            return;
        const points at(s->dimension, count, all.data());
        box_list standing(here.size()), moved(there.size());
        place(here, standing, at);
        place(there, moved, at);
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
