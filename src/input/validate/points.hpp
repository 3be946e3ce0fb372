/* Exact points for the validation: order along the axes, equality of positions, and the two
 * orientation signs every test is made of.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The rationals are borrowed; ranks and doubles, which settle most signs, are computed once.
 */
#ifndef GRAZE_VALIDATE_POINTS_HPP
#define GRAZE_VALIDATE_POINTS_HPP

#include <cstdint>
#include <vector>
#include <flint/fmpq.h>
#include <flint/fmpz.h>
#include <flint/fmpz_vec.h>
#include <gmpxx.h>

/** A vector of integers, 0 at first, that clears itself. */
class integers {
  public:
    explicit integers(slong count) : count_(count), value_(_fmpz_vec_init(count)) {
    }
    ~integers() {
        _fmpz_vec_clear(value_, count_);
    }
    integers(const integers &) = delete;
    integers &operator=(const integers &) = delete;
    fmpz *operator[](std::size_t i) const {
        return value_ + i;
    }

  private:
    slong count_;
    fmpz *value_;
};

/**
 * Points numbered from 0, of dimension 2 or 3. One object is used by one thread at a time: the
 * signs share scratch numbers.
 */
class points {
  public:
    /** `coordinates` are count * dimension canonical rationals, borrowed as long as this lives. */
    points(int dimension, std::size_t count, const fmpq *coordinates);

    int dimension() const {
        return dimension_;
    }
    std::size_t count() const {
        return count_;
    }
    /** The smallest number of a point at the same position. */
    std::uint32_t position(std::uint32_t v) const {
        return position_[v];
    }
    /** Place of v in the order along an axis; equal coordinates have equal ranks. */
    std::uint32_t rank(std::uint32_t v, int axis) const {
        return rank_[v * static_cast<std::size_t>(dimension_) + axis];
    }
    /** An axis along which two different positions differ. */
    int axis_between(std::uint32_t a, std::uint32_t b) const;
    /** The coordinate times the common denominator of its axis, hence an integer; where a common
     * denominator would be too long, no axis is multiplied. */
    mpq_class coordinate(std::uint32_t v, int axis) const;

    /**
     * Sign of the turn a, b, c after dropping coordinate `drop` (2, 1 or 0; in E^2 it is 2): the
     * sign of that coordinate of the normal (b - a) x (c - a).
     */
    int turn(int drop, std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
    /** Sign of det(b - a, c - a, d - a): +1 if d is on the side the normal of a, b, c points to. */
    int side(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const;

  private:
    void find_common();
    void approximate();
    void order();
    int compare(std::uint32_t u, std::uint32_t v, int axis) const;
    void differences(int first, int step, std::uint32_t a, const std::uint32_t *others, int count,
                     int axis) const;
    int exact_turn(int i, int j, std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
    int exact_side(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const;
    const fmpq *exact(std::uint32_t v, int axis) const {
        return coordinates_ + v * static_cast<std::size_t>(dimension_) + axis;
    }
    double approximation(std::uint32_t v, int axis) const {
        return approximation_[v * static_cast<std::size_t>(dimension_) + axis];
    }

    int dimension_;
    std::size_t count_;
    const fmpq *coordinates_;
    integers common_; /* one per axis */
    std::vector<double> approximation_;
    std::vector<std::uint32_t> rank_, position_;
    mutable integers scratch_;
};

#endif
